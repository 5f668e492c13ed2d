// Evaluations and episodes that end early in the middle of something long.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "common/stop_request.h"
#include "ranks/distributed_evaluation.h"
#include "robots/controllers/robot_way.h"
#include "simulation/crowd_decider.h"
#include "simulation/episode.h"
#include "simulation/evaluation/evaluation.h"
#include "support/evaluations.h"
#include "support/thread_ranks.h"

namespace crowd::stopping_test {
namespace {

using evaluations::planOf;
using evaluations::restlessTable;

/// A request that is made when it was asked a number of times.
class Countdown {
 public:
  explicit Countdown(std::uint64_t times) : left_(times) {}
  StopRequest request() {
    return StopRequest([this] {
      ++asked_;
      if (left_ > 0) --left_;
      return left_ == 0;
    });
  }
  std::uint64_t asked() const { return asked_; }

 private:
  std::atomic<std::uint64_t> left_;
  std::atomic<std::uint64_t> asked_{0};
};

const std::string HEAD = "name: n\nduration: 5\ngoal_tolerance: 0.3\n";

/// A scenario in which something takes long in one tick or before the first one.
struct LongWork {
  const char* what;
  std::string keys;
};

std::string manyTimes() {
  std::string times = "0";
  for (int i = 1; i < 300; ++i) times += ", 0";
  return times;
}

/// A mesh is made once for a floor. @param floor its number: others have another mesh
std::string manyWalls(int floor) {
  std::string walls = "walls: [[[-9, 9], [" + std::to_string(floor) + ", 9]]";
  for (int x = 0; x < 50; ++x) walls += ", [[" + std::to_string(x) + ", 0], [" + std::to_string(x) + ", 3]]";
  return walls + "]\n";
}

const std::string CROWD = "agents: [{count: 300, position: {box: [[0, 0], [90, 90]]}, speed: 1, radius: 0.2, ";
const std::string TO_ANYWHERE = CROWD + "goal: {box: [[0, 0], [90, 90]]}}]\n";
const std::string ONE = "agents: [{position: [-5, 0], goal: [60, 0], speed: 1, radius: 0.2}]\n";
const std::string ROBOT = "robots: [{name: tug, position: [-5, 0], goal: [60, 0], radius: 0.4, max_speed: 1}]\n";

/// Works in the constructor of an episode.
std::vector<LongWork> firstWorks(int floor) {
  return {{"people who enter in one tick",
           "sources: [{area: {box: [[0, 0], [90, 90]]}, goal: [99, 9], speed: 1, radius: 0.2, times: [" + manyTimes() +
               "]}]\n"},
          {"agents that begin routes", CROWD + "route: home}]\nroutes: {home: {waypoints: [{place: [99, 9]}]}}\n"},
          {"agents that react later", CROWD + "reaction_time: 2, goal: [99, 99]}]\n"},
          {"a mesh", ONE + manyWalls(floor)}};
}

TEST(Stopping, AnEpisodeDoesNotBegin) {
  for (const LongWork& work : firstWorks(1)) {
    SCOPED_TRACE(work.what);
    const Scene scene = parseScenarios(HEAD + work.keys, "s.yaml").scene(1, 0);
    Countdown countdown(40);
    EXPECT_THROW(Episode(scene, 0, Vision(), ThreadPool::callerOnly(), countdown.request()), Stopped);
    EXPECT_EQ(countdown.asked(), 40U);
  }
}

TEST(Stopping, AgentsAreNotPlaced) {
  const ScenarioList scenarios = parseScenarios(HEAD + TO_ANYWHERE, "s.yaml");
  Countdown countdown(100);
  EXPECT_THROW(scenarios.scene(1, 0, countdown.request()), Stopped);
  EXPECT_EQ(countdown.asked(), 100U);
}

TEST(Stopping, ARobotDoesNotLookForItsWay) {
  const Scene scene = parseScenarios(HEAD + ROBOT + manyWalls(2), "s.yaml").scene(1, 0);
  Countdown countdown(40);
  const World world(scene, countdown.request());
  RobotWay way;
  EXPECT_THROW(way.next(world, world.robots()[0], {60.0, 0.0}), Stopped);
  EXPECT_EQ(countdown.asked(), 40U);
}

TEST(Stopping, ATickIsNotFinished) {
  Countdown countdown(3);
  Episode episode(parseScenarios(HEAD + TO_ANYWHERE, "s.yaml").scene(1, 0), 0, Vision(), ThreadPool::callerOnly(),
                  countdown.request());
  Learner learner = makeDemoLearner(restlessTable(), 1);
  CrowdDecider decider(learner);
  EXPECT_THROW(episode.walk(decider), Stopped);  // the agents are several blocks
  EXPECT_EQ(countdown.asked(), 3U);
  EXPECT_THROW(episode.step({}), Stopped);
  EXPECT_EQ(episode.world().tick(), 0U);
}

TEST(Stopping, FinishedEpisodesAreThoseOfAWholeRun) {
  const std::vector<EvaluatedEpisode> whole = evaluations::evaluateAll(planOf(12, 1));
  for (const unsigned threads : {1U, 4U}) {
    Countdown countdown(400);
    EvaluationPlan plan = planOf(12, threads);
    plan.stop = countdown.request();
    std::vector<EvaluatedEpisode> part = evaluations::evaluateAll(plan);
    EXPECT_LT(part.size(), whole.size());
    for (std::size_t i = 0; i < part.size(); ++i) evaluations::expectSame(part[i], whole[i]);
  }
}

TEST(Stopping, AnEpisodeWithoutRobotsOfAPeopleDelayEnds) {
  const ScenarioList scenarios =
      parseScenarios(HEAD +
                         "agents: [{position: [0, 0], goal: [40, 0], speed: 1, radius: 0.2}]\n"
                         "robots: [{name: tug, position: [0, 3], goal: [1, 3], radius: 0.3, max_speed: 1}]\n",
                     "s.yaml");
  EvaluationPlan plan = planOf(1, 1);
  plan.people_delay = true;
  Countdown never(UINT64_MAX);
  plan.stop = never.request();
  EXPECT_TRUE(evaluate(restlessTable(), scenarios, plan, [](EvaluatedEpisode&) { return true; }));
  Countdown late(never.asked() - 5);
  plan.stop = late.request();
  EXPECT_FALSE(evaluate(restlessTable(), scenarios, plan, [](EvaluatedEpisode&) {
    ADD_FAILURE() << "the episode was not finished";
    return true;
  }));
}

TEST(Stopping, AllRanksEndWhenOneLeavesAnEpisodeInItsMiddle) {
  std::vector<LongWork> works = firstWorks(3);
  works.push_back({"agents that are placed", TO_ANYWHERE});
  works.push_back({"a robot", ROBOT + manyWalls(4)});
  for (const LongWork& work : works) {
    SCOPED_TRACE(work.what);
    const ScenarioList scenarios = parseScenarios(HEAD + work.keys, "s.yaml");
    const int stopped = isDivisible(scenarios.scene(1, 0)) ? 1 : 0;  // rank 0 walks other scenes alone
    for (const std::uint64_t times : {1U, 5U, 40U, 100U, 200U}) {
      ThreadRanks(3).run([&](Communicator& communicator) {
        Countdown countdown(communicator.rank() == stopped ? times : UINT64_MAX);
        EvaluationPlan plan = planOf(3, 1);
        plan.robot_controller = "learned";
        plan.stop = countdown.request();
        EXPECT_FALSE(evaluateOnRanks(communicator, restlessTable(), scenarios, plan, {},
                                     [](EvaluatedEpisode&) { return true; }));
      });
    }
  }
}

}  // namespace
}  // namespace crowd::stopping_test
