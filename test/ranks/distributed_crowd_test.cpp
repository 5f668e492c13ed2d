#include "ranks/distributed_crowd.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "simulation/episode_runner.h"
#include "simulation/evaluation/trajectory.h"
#include "support/evaluations.h"
#include "support/scenes.h"
#include "support/seeds.h"
#include "support/thread_ranks.h"
#include "training/record.h"

namespace crowd::distributed_crowd_test {
namespace {

constexpr std::uint64_t EPISODE = 3;

/// What one walk of a crowd gives, as the bytes of the files.
struct Walked {
  std::string trajectory;
  std::string record;
  std::uint64_t ticks = 0;
  RanksReport report;
};

TrainedTable tableOf(const std::string& name) { return loadQTable(SOURCE_DIR "/config/q_tables/" + name + ".txt"); }

Walked walkAlone(const Scene& scene, const TrainedTable& trained) {
  Walked walked;
  Learner learner = makeDemoLearner(trained, 1);
  Episode episode(scene, EPISODE, learner.model().vision());
  EpisodeObserver observer;
  observer.on_tick = [&](const World& world) { appendTrajectoryRows(EPISODE, world, walked.trajectory); };
  CrowdDecider decider(learner);
  const EpisodeResult result = runEpisode(episode, decider, observer);
  appendRecordRows(EPISODE, result, walked.record);
  walked.ticks = result.ticks;
  return walked;
}

Walked walkOnRanks(int ranks, const Scene& scene, const TrainedTable& trained,
                   const DistributedCrowd::Options& options = {}, unsigned threads = 1) {
  Walked walked;
  ThreadRanks(ranks).run([&](Communicator& communicator) {
    ThreadPool thread_pool(threads);
    Learner learner = makeDemoLearner(trained, 1);
    DistributedCrowd crowd(scene, EPISODE, learner, thread_pool, communicator, options);
    std::string rows;
    do crowd.appendTrajectoryRows(rows);
    while (crowd.step());
    const EpisodeResult result = crowd.result();
    const RanksReport report = crowd.report();
    if (communicator.rank() != 0) return;
    walked.trajectory = rows;
    appendRecordRows(EPISODE, result, walked.record);
    walked.ticks = result.ticks;
    walked.report = report;
  });
  return walked;
}

void expectSame(const Walked& walked, const Walked& alone) {
  EXPECT_EQ(walked.ticks, alone.ticks);
  EXPECT_TRUE(walked.trajectory == alone.trajectory) << "the trajectories differ";
  EXPECT_EQ(walked.record, alone.record);
}

Scene withoutWays(Scene scene, std::uint64_t ticks) {
  scene.way_finding = false;
  scene.max_ticks = ticks;
  return scene;
}

/// Compares walks on 1 to 4 ranks with one episode.
void compare(const Scene& scene, const TrainedTable& trained, const DistributedCrowd::Options& options = {}) {
  const Walked alone = walkAlone(scene, trained);
  for (int ranks = 1; ranks <= 4; ++ranks) {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    expectSame(walkOnRanks(ranks, scene, trained, options), alone);
  }
}

TEST(DistributedCrowd, WalksAsOneEpisodeInGhostWorlds) {
  for (const char* const table : {"anticipation", "human"}) {
    SCOPED_TRACE(table);
    const TrainedTable trained = tableOf(table);
    forSeeds(4, KeyedRandom::PLACEMENT, [&](std::uint64_t seed, KeyedRandom& /*random*/) {
      compare(withoutWays(scenes::randomScene(seed, 150, 25.0), 60), trained);
    });
  }
}

TEST(DistributedCrowd, WalksAsOneEpisodeInSmallWorlds) {
  const TrainedTable trained = tableOf("anticipation");
  forSeeds(20, KeyedRandom::PLACEMENT, [&](std::uint64_t seed, KeyedRandom& /*random*/) {
    compare(withoutWays(scenes::randomScene(seed, 12, 12.0), 40), trained);
  });
}

TEST(DistributedCrowd, WalksAsOneEpisodeInSolidWorlds) {
  for (const char* const table : {"anticipation", "human"}) {
    SCOPED_TRACE(table);
    const TrainedTable trained = tableOf(table);
    forSeeds(4, KeyedRandom::PLACEMENT, [&](std::uint64_t seed, KeyedRandom& /*random*/) {
      compare(withoutWays(scenes::solidCrowd(seed, 120, 2.0, 4), 50), trained);
    });
  }
}

/// A table with which agents walk straight ahead, whatever is there.
TrainedTable stubbornTable() {
  TrainedTable trained = evaluations::restlessTable();
  for (Row row = 0; row < trained.table.rows(); ++row) {
    for (Action action = 0; action < trained.table.actions(); ++action) {
      trained.table.set(row, action, action == 0 ? 1.0 : 0.0, 1);
    }
  }
  return trained;
}

/// A long row of solid agents that walk to a wall, one behind the other, with small gaps: those in front stop those
/// behind them, along the whole row within a tick.
Scene row(std::uint64_t seed) {
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
  Scene made = scenes::solid(scenes::scene({}));
  double x = 0.0;
  const double gap = 0.002 * static_cast<double>(seed);
  for (int i = 0; i < 100; ++i) {
    made.agents.push_back(scenes::wanderer({x, 0.0}, 1.0, 0.25));
    x += 0.5 + random.uniform(0.0, gap);
  }
  const double wall = x - 0.25;
  made.walls.push_back({{wall, -1.0}, {wall, 1.0}});
  return withoutWays(made, 12);
}

TEST(DistributedCrowd, FollowsChainsOfImpactsThroughAllRanks) {
  const TrainedTable trained = stubbornTable();
  std::map<std::uint64_t, std::uint64_t> whole_motions;  // of 36 ticks, by seed
  forSeeds(6, KeyedRandom::PLACEMENT, [&](std::uint64_t seed, KeyedRandom& /*random*/) {
    const Scene scene = row(seed);
    const Walked alone = walkAlone(scene, trained);
    for (int ranks = 2; ranks <= 4; ++ranks) {
      SCOPED_TRACE(std::to_string(ranks) + " ranks");
      const Walked walked = walkOnRanks(ranks, scene, trained, {3});
      expectSame(walked, alone);
      // In a row without gaps all stop at the same instant in each tick; with wide ones, chains end within the copies.
      whole_motions[seed] += walked.report.whole_motions;
    }
  });
  EXPECT_EQ(whole_motions[0], 36U);
  EXPECT_GT(whole_motions[1], 0U);
  EXPECT_LT(whole_motions[5], 36U);
}

TEST(DistributedCrowd, WalksAsOneEpisodeWhereAgentsBumpAllTheTime) {
  const TrainedTable trained = evaluations::restlessTable();
  forSeeds(4, KeyedRandom::PLACEMENT, [&](std::uint64_t seed, KeyedRandom& /*random*/) {
    compare(withoutWays(scenes::solidCrowd(seed, 600, 2.0, 6), 20), trained, {1 + seed});
  });
}

/// Two groups that walk through each other, from one end of the floor to the other.
Scene counterflow(Contact contact) {
  Scene made = scenes::scene({});
  made.contact = contact;
  for (int i = 0; i < 120; ++i) {
    const double x = 1.0 * (i % 20);
    const double y = 1.2 * static_cast<double>(i / 20);
    const double speed = 1.0 + 0.005 * i;
    if (i % 2 == 0) made.agents.push_back(scenes::agent({x, y}, {x + 30.0, y}, speed));
    if (i % 2 == 1) made.agents.push_back(scenes::agent({40.0 + x, y}, {x + 10.0, y}, speed));
  }
  return withoutWays(made, 400);
}

TEST(DistributedCrowd, HandsOverAgentsThatCrossBordersUntilAllHaveArrived) {
  const TrainedTable trained = tableOf("anticipation");
  for (const Contact contact : {Contact::GHOST, Contact::SOLID}) {
    const Scene scene = counterflow(contact);
    const Walked alone = walkAlone(scene, trained);
    EXPECT_LT(alone.ticks, 400U) << "all have arrived";
    compare(scene, trained);
    for (const std::uint64_t ticks : {1U, 7U, 50U}) expectSame(walkOnRanks(3, scene, trained, {ticks}), alone);
    expectSame(walkOnRanks(2, scene, trained, {}, 2), alone);
  }
}

TEST(DistributedCrowd, KeepsAgentsThatStay) {
  const TrainedTable trained = tableOf("anticipation");
  for (const Contact contact : {Contact::GHOST, Contact::SOLID}) {
    Scene scene = counterflow(contact);
    for (AgentStart& start : scene.agents)
      start.goals.front().x() = 0.5 * (start.goals.front().x() + start.position.x());
    const Walked leaving = walkAlone(scene, trained);
    for (AgentStart& start : scene.agents) start.stays = true;
    EXPECT_NE(walkAlone(scene, trained).trajectory, leaving.trajectory);
    compare(scene, trained);
    for (const std::uint64_t ticks : {1U, 7U, 50U}) {
      expectSame(walkOnRanks(3, scene, trained, {ticks}), walkAlone(scene, trained));
    }
  }
}

TEST(DistributedCrowd, WorksWithMoreRanksThanAgents) {
  const TrainedTable trained = tableOf("anticipation");
  const Scene few =
      withoutWays(scenes::scene({scenes::agent({0.0, 0.0}, {5.0, 0.0}), scenes::agent({5.0, 0.0}, {0.0, 0.0})}), 100);
  const Scene empty = withoutWays(scenes::scene({}), 100);
  const Scene one_place =
      withoutWays(scenes::scene(std::vector<AgentStart>(5, scenes::agent({1.0, 1.0}, {5.0, 0.0}))), 100);
  for (const Scene& scene : {few, empty, one_place}) {
    const Walked alone = walkAlone(scene, trained);
    for (const int ranks : {2, 5, 8}) {
      SCOPED_TRACE(std::to_string(ranks) + " ranks");
      expectSame(walkOnRanks(ranks, scene, trained), alone);
    }
  }
}

TEST(DistributedCrowd, BreaksTiesByTheNumbersOfTheScene) {
  TrainedTable trained = evaluations::restlessTable();
  trained.table = QTable(trained.table.rows(), trained.table.actions());  // all actions have equal values
  trained.parameters.ties = Ties::RANDOM;
  compare(withoutWays(scenes::randomScene(5, 100, 20.0), 30), trained);
}

TEST(IsDivisible, NeedsAgentsThatAreIndependentOfWaysAndTurns) {
  Scene scene = scenes::randomScene(1);
  scene.walls = {{{0.0, 0.0}, {1.0, 0.0}}};
  EXPECT_FALSE(isDivisible(scene));
  scene.way_finding = false;
  EXPECT_TRUE(isDivisible(scene));
  scene.order = Order::SEQUENTIAL;
  EXPECT_FALSE(isDivisible(scene));
  scene.order = Order::SIMULTANEOUS;
  scene.agents.front().reaction_time = 1.0;
  EXPECT_FALSE(isDivisible(scene));
  scene.agents.front().reaction_time = 0.0;
  EXPECT_TRUE(isDivisible(scene));
  scene.robots.emplace_back();
  EXPECT_FALSE(isDivisible(scene));
}

}  // namespace
}  // namespace crowd::distributed_crowd_test
