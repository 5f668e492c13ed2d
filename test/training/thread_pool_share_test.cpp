#include <gtest/gtest.h>

#include "simulation/crowd_decider.h"
#include "simulation/episode.h"
#include "support/learners.h"
#include "support/scenes.h"
#include "support/worlds.h"
#include "training/training.h"

namespace crowd::thread_pool_share_test {
namespace {

Scene crowd(std::uint64_t seed) {
  Scene scene = scenes::randomCrowd(seed);
  scene.max_ticks = 30;
  return scene;
}

Learner makeLearner(Mode mode) {
  const Model model = parseModel(
      "{state_set: {type: anticipation}, action_set: {type: goal_relative, gap_sharing: moving}, reward: {type: "
      "progress}}");
  Learner::Options options;
  options.mode = mode;
  return {model, options, learners::randomTable(model, 3)};
}

struct Walked {
  std::vector<double> state;
  std::vector<double> metrics;
  QTable table;
};

/// @param at_once whether all agents of a tick decide in one call, as in a node, or in parts, as in headless runs
Walked walk(const Scene& scene, Mode mode, unsigned threads, bool at_once = false) {
  ThreadPool thread_pool(threads);
  Learner learner = makeLearner(mode);
  Episode episode(scene, 1, learner.model().vision(), thread_pool);
  RelativeActions actions;
  CrowdDecider decider(learner, thread_pool);
  while (!at_once && episode.walk(decider)) continue;
  for (; !episode.isOver(); episode.step(actions.agents)) learner.decide(episode.perceptions(), actions);
  if (at_once) learner.decide(episode.perceptions(), actions);
  Walked walked{stateOf(episode.world()), {}, learner.tables().of(0)};
  for (const AgentResult& agent : episode.result().agents) {
    walked.metrics.insert(walked.metrics.end(), {agent.path_length, agent.turn_per_metre, agent.touched ? 1.0 : 0.0});
  }
  return walked;
}

TEST(ThreadPoolShare, EpisodesDoNotDependOnTheNumberOfThreads) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Scene ghosts = crowd(seed);
    for (const Scene& scene : {ghosts, scenes::solid(ghosts)}) {
      for (const Mode mode : {Mode::DEMO, Mode::TRAINING}) {
        const Walked expected = walk(scene, mode, 1);
        const auto expect_same = [&](unsigned threads, bool at_once) {
          SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << MODES.nameOf(mode) << ", " << threads
                                          << " threads" << (at_once ? ", all at once" : ""));
          const Walked walked = walk(scene, mode, threads, at_once);
          EXPECT_EQ(walked.state, expected.state);
          EXPECT_EQ(walked.metrics, expected.metrics);
          EXPECT_TRUE(walked.table == expected.table);
        };
        for (const unsigned threads : {2U, 7U}) expect_same(threads, false);
        expect_same(1, true);
      }
    }
  }
}

TEST(ThreadPoolShare, EpisodesDependOnLearning) {
  const Walked before = walk(crowd(1), Mode::DEMO, 1);
  const Walked learned = walk(crowd(1), Mode::TRAINING, 1);
  EXPECT_NE(before.state, learned.state);
  EXPECT_FALSE(before.table == learned.table);
}

}  // namespace
}  // namespace crowd::thread_pool_share_test
