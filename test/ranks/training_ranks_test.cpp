// Learners side by side on several ranks: the same bytes as in one process.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "common/random.h"
#include "simulation/evaluation/robot_record.h"
#include "support/error_of.h"
#include "support/seeds.h"
#include "support/temporary_folder.h"
#include "support/thread_ranks.h"
#include "training/checkpoint.h"
#include "training/record.h"
#include "training/training.h"

namespace crowd::training_ranks_test {
namespace {

/// Agents that keep their headings from one episode to the next, and agents with a robot that stands in their way.
constexpr const char* SCENARIOS =
    "name: kept\n"
    "duration: 3\n"
    "goal_tolerance: 0.3\n"
    "agents: [{count: 3, position: {ring: {centre: [0, 0], radius: [1, 2]}}, goal: {opposite: [0, 0]}, speed: 1.2,\n"
    "          radius: 0.2, heading: kept}]\n"
    "obstacles: [{position: [0, 0], radius: 0.2}]\n"
    "---\n"
    "name: robot\n"
    "duration: 2\n"
    "goal_tolerance: 0.3\n"
    "contact: solid\n"
    "agents: [{count: 2, position: {ring: {centre: [0, 0], radius: [1, 2]}}, goal: {opposite: [0, 0]}, speed: 1.2,\n"
    "          radius: 0.2}]\n"
    "robots: [{name: robot, position: [0, 0], goal: [3, 0], radius: 0.3, max_speed: 1}]\n";

/// What a training leaves.
struct Outcome {
  std::string rows;   // of record, robots and log
  std::string table;  // file
  std::string checkpoint;
  std::optional<TrainingState> state;

  friend bool operator==(const Outcome& a, const Outcome& b) {
    return a.rows == b.rows && a.table == b.table && a.checkpoint == b.checkpoint;
  }
};

class TrainingRanks : public testing::Test {
 protected:
  TrainingRanks() { folder_.write("s.yaml", SCENARIOS); }

  TrainingConfig config(std::uint64_t episodes, std::uint32_t side_by_side, std::uint32_t turn, std::uint64_t seed = 1,
                        const std::string& learning = "alpha: 0.1") const {
    TrainingConfig config =
        readTrainingConfig(folder_.write("config.yaml",
                                         "state_set: {type: nearest_obstacle}\n"
                                         "action_set: {type: kings_moves}\n"
                                         "reward: {goal: cosine_cubed, obstacle_cost: 80}\n"
                                         "learning: {gamma: 0.5, epsilon: {from: 0.5, to: 0.1, episodes: 20}, " +
                                             learning + "}\ntraining: {scenarios: [s.yaml], episodes: 1}\n"));
    config.training.episodes = episodes;
    config.training.side_by_side = side_by_side;
    config.training.turn = turn;
    config.training.seed = seed;
    return config;
  }

  /// Runs turns, from a state or from the beginning. Returns what rank 0 has then.
  static Outcome run(Training& training, const TrainingState* from, std::uint64_t turns) {
    Outcome outcome;
    if (from != nullptr) training.restore(*from);
    training.countVisitedRows();
    for (std::uint64_t i = 0; i < turns && !training.isDone(); ++i) {
      std::uint64_t number = training.episode();
      for (const LearnedEpisode& episode : training.runNextTurn()) {
        appendRecordRows(number, episode, outcome.rows);
        appendRobotRows(number, episode, outcome.rows);
        appendLogRow(number, episode, outcome.rows);
        outcome.rows += episode.scenario + " " + std::to_string(episode.ticks) + "\n";
        ++number;
      }
    }
    outcome.table = toText(training.trained());
    outcome.state = training.state();
    outcome.checkpoint = toText(Checkpoint{"", {}, training.state()});
    return outcome;
  }

  static Outcome onRanks(const TrainingConfig& config, int ranks, unsigned threads, const TrainingState* from = nullptr,
                         std::uint64_t turns = UINT64_MAX) {
    Outcome outcome;
    ThreadRanks(ranks).run([&](Communicator& communicator) {
      Training training(config, threads, communicator);
      Outcome own = run(training, from, turns);
      if (communicator.rank() == 0) {
        outcome = std::move(own);
      } else if (!own.rows.empty()) {
        throw Error("a rank but the first has episodes");
      }
    });
    return outcome;
  }

  static Outcome alone(const TrainingConfig& config, const TrainingState* from = nullptr,
                       std::uint64_t turns = UINT64_MAX) {
    Training training(config);
    return run(training, from, turns);
  }

  TemporaryFolder folder_;
};

TEST_F(TrainingRanks, GiveTheSameBytesAsOneProcess) {
  const std::vector<std::string> plans = {"alpha: 0.1", "alpha: 0.01, alpha_decay: 0.7, mirrored: true, ties: random"};
  forSeeds(25, KeyedRandom::CONTENT, [&](std::uint64_t seed, KeyedRandom& random) {
    const std::uint32_t learners = 2 + random.below(6);
    const int ranks = 2 + static_cast<int>(random.below(std::min(learners, 5U) - 1));
    const unsigned threads = 1 + random.below(3);
    const TrainingConfig plan =
        config(1 + random.below(40), learners, 1 + random.below(4), seed, plans[random.below(2)]);
    SCOPED_TRACE(std::to_string(learners) + " learners, " + std::to_string(ranks) + " ranks, " +
                 std::to_string(threads) + " threads, turns of " + std::to_string(plan.training.turn) + ", " +
                 std::to_string(plan.training.episodes) + " episodes");
    const Outcome expected = alone(plan);
    const Outcome got = onRanks(plan, ranks, threads);
    EXPECT_EQ(got.rows, expected.rows);
    EXPECT_TRUE(got == expected) << "table or checkpoint";
  });
}

TEST_F(TrainingRanks, GoOnFromAStateOfAnyNumberOfRanks) {
  forSeeds(10, KeyedRandom::CONTENT, [&](std::uint64_t seed, KeyedRandom& random) {
    const std::uint32_t learners = 3 + random.below(3);
    const TrainingConfig plan = config(30, learners, 2, seed);
    const Outcome whole = alone(plan);
    const std::uint64_t turns = 1 + random.below(2);
    const Outcome early_alone = alone(plan, nullptr, turns);
    const Outcome early = onRanks(plan, 2, 1, nullptr, turns);
    EXPECT_TRUE(early == early_alone);
    for (const Outcome& late : {onRanks(plan, 3, 2, &*early.state), alone(plan, &*early.state)}) {
      EXPECT_EQ(early.rows + late.rows, whole.rows);
      EXPECT_EQ(late.table, whole.table);
      EXPECT_EQ(late.checkpoint, whole.checkpoint);
    }
  });
}

TEST_F(TrainingRanks, ContinueFromATable) {
  const TrainingConfig plan = config(13, 3, 2);
  Training first(plan);
  run(first, nullptr, 2);
  const TrainedTable begin = first.trained();
  Training more(plan, begin);
  const Outcome expected = run(more, nullptr, UINT64_MAX);
  ThreadRanks(2).run([&](Communicator& communicator) {
    Training training(plan, begin, 1, communicator);
    const Outcome got = run(training, nullptr, UINT64_MAX);
    EXPECT_TRUE(communicator.rank() != 0 || got == expected);
    EXPECT_EQ(training.trained().table, more.trained().table) << "on each rank";
  });
}

TEST_F(TrainingRanks, AreNotMoreThanLearners) {
  const TrainingConfig plan = config(12, 2, 2);
  ThreadRanks(3).run([&](Communicator& communicator) {
    EXPECT_EQ(errorOf<InputError>([&] { Training(plan, 1, communicator); }),
              "training.side_by_side: expected 3 or more learners side by side for 3 ranks, got 2: set it, or start "
              "fewer ranks");
  });
}

TEST_F(TrainingRanks, AllEndWithTheErrorOfOneEpisode) {
  TrainingConfig plan = config(200, 4, 5);
  // Whether all agents fit depends on the radii that an episode draws.
  plan.training.scenarios = {folder_.write("tight.yaml",
                                           "name: tight\n"
                                           "duration: 1\n"
                                           "goal_tolerance: 0.3\n"
                                           "contact: solid\n"
                                           "agents: [{count: 3, position: {box: [[0, 0], [0.9, 0.9]]},\n"
                                           "          goal: {opposite: [0, 0]}, speed: 1, radius: [0.05, 0.5]}]\n")};
  std::vector<std::string> problems(3);
  ThreadRanks(3).run([&](Communicator& communicator) {
    Training training(plan, 1, communicator);
    problems[static_cast<std::size_t>(communicator.rank())] = errorOf<SharedError>([&] {
      while (!training.isDone()) training.runNextTurn();
    });
  });
  EXPECT_TRUE(contains(problems[0], "rank ")) << problems[0];
  EXPECT_TRUE(contains(problems[0], "no free place")) << problems[0];
  EXPECT_EQ(problems[1], problems[0]);
  EXPECT_EQ(problems[2], problems[0]);
}

TEST(TurnsReport, HasTheSlowestRankAndAllBytes) {
  ThreadRanks(2).run([](Communicator& communicator) {
    const bool is_first = communicator.rank() == 0;
    const TurnTimes times{4, is_first ? 3.5 : 3.6, is_first ? 3.0 : 1.0, is_first ? 0.1 : 0.2, is_first ? 700U : 500U};
    const TurnsReport report = reportOf(communicator, times, 16);
    EXPECT_EQ(report.turns, 4U);
    EXPECT_EQ(report.seconds, 3.6);
    EXPECT_EQ(report.episode_seconds, 3.0);
    EXPECT_EQ(report.exchange_seconds, 0.2);
    EXPECT_EQ(report.bytes, 1200U);
    EXPECT_EQ(report.imbalance, 1.5);  // 3 s / 2 s
  });
}

TEST_F(TrainingRanks, ReportTheirTimes) {
  const TrainingConfig plan = config(20, 5, 2);
  ThreadRanks(2).run([&](Communicator& communicator) {
    Training training(plan, 1, communicator);
    run(training, nullptr, UINT64_MAX);
    const TurnsReport report = training.report();
    EXPECT_EQ(report.ranks, 2);
    EXPECT_EQ(report.learners, 5U);
    EXPECT_EQ(report.turns, 2U);
    EXPECT_GT(report.bytes, 0U);
    EXPECT_GT(report.episode_seconds, 0.0);
    EXPECT_TRUE(contains(report.text(), "2 ranks, 5 learners, 2 turns: ")) << report.text();
  });
}

}  // namespace
}  // namespace crowd::training_ranks_test
