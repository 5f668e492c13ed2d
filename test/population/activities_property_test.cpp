#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "simulation/crowd_decider.h"
#include "simulation/episode.h"
#include "support/anticipation.h"
#include "support/straight_walk.h"

namespace crowd::activities_property_test {
namespace {

/// A hall with two shop windows, a queue and two exits, groups, and people who stop to look at their phones.
std::string hall(KeyedRandom& random, const std::string& more) {
  const auto text = [&](double low, double high) { return std::to_string(random.uniform(low, high)); };
  return "walls: [[[0, 0], [16, 0]], [[16, 0], [16, 12]], [[16, 12], [0, 12]], [[0, 12], [0, 0]], [[8, 3], [8, 9]]]\n"
         "contact: solid\n"
         "agents:\n"
         "  - {count: 15, position: {box: [[1, 1], [15, 11]]}, route: rounds, speed: [1, 1.5], radius: [0.18, 0.25], "
         "groups: {share: 0.5}}\n"
         "  - {count: 10, position: {box: [[1, 1], [15, 11]]}, goals: [{box: [[1, 1], [15, 11]]}, {box: [[1, 1], [15, "
         "11]]}], speed: 1.2, hurry: [0.8, 1.4], radius: 0.2, kind: {adult: 1, phone_stop: 1}}\n"
         "sources: [{area: {box: [[0.5, 0.5], [2, 2]]}, rate: 0.5, route: shop, speed: [1, 1.5], radius: 0.2, groups: "
         "{share: 0.4}}]\n"
         "routes:\n"
         "  rounds: {repeat: true, waypoints: [{place: {box: [[1, 1], [15, 11]]}, wait: [0, 6], face: [8, 6]}]}\n"
         "  shop: {waypoints: [{place: {box: [[9, 1], [15, 11]]}}, {queue: till}, {sink: nearest}]}\n"
         "queues: {till: {head: [14, 6], direction: 180, spacing: 0.6, service: [0, 2], face: 0}}\n"
         "sinks: {a: {area: {box: [[15, 0], [16, 2]]}}, b: {area: {box: [[0, 10], [1, 12]]}}}\n"
         "attractions:\n"
         "  window: {area: {box: [[" +
         text(1, 3) + ", 1], [" + text(4, 7) + ", 2]]}, radius: 4, share: 0.5, wait: [2, 9], face: -90}\n" +
         "  stall: {area: {ring: {centre: [" + text(10, 13) + ", 9], radius: [0.4, 1.2]}}, radius: 3, share: 0.6, " +
         "wait: [2, 9]}\n" + more;
}

/// Nobody touches anybody, and after the alarm everybody leaves.
TEST(Activities, NoContactsAndEverybodyLeaves) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    KeyedRandom random(seed, KeyedRandom::CONTENT, {});
    const std::string alarm =
        "alarms: [{time: 40, area: all, sink: nearest, speed_factor: " + std::to_string(random.uniform(1.0, 1.6)) +
        ", reaction_time: [0, 5]}]\n";
    Scene scene = straight_walk::sceneOf(hall(random, alarm), 150.0, seed);
    scene.tick_duration = 0.1;
    scene.max_ticks = 1500;
    Learner learner = anticipationLearner();
    CrowdDecider decider(learner);
    Episode episode(scene, 0, learner.model().vision());
    std::size_t visits = 0;
    while (!episode.isOver()) {
      if (!episode.walk(decider)) break;
      for (const Agent& agent : episode.world().agents()) visits += agent.isHeldBy(Hold::ATTRACTION) ? 1U : 0U;
    }
    const EpisodeResult result = episode.result();
    EXPECT_GT(visits, 250U) << "seed " << seed;
    EXPECT_EQ(episode.world().activeCount(), 0U) << "seed " << seed;
    EXPECT_LT(episode.world().time(), 100.0) << "seed " << seed;
    for (AgentId id = 0; id < result.agents.size(); ++id) {
      EXPECT_FALSE(result.agents[id].touched) << "seed " << seed << ", agent " << id;
    }
  }
}

/// People of all reactions and a robot that turns at random: nobody walks into anybody, or into the robot.
TEST(Activities, ReactionsToARobotCauseNoContacts) {
  std::set<Reaction> reacted;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    KeyedRandom random(seed, KeyedRandom::CONTENT, {});
    Scene scene = straight_walk::sceneOf(
        hall(random, "robots: [{name: r, position: [4, 6], radius: 0.3, max_speed: 0.8, yields: both}]\n"), 60.0, seed);
    for (std::size_t i = 0; i < scene.agents.size(); ++i) scene.agents[i].reaction = static_cast<Reaction>(i % 6);
    scene.tick_duration = 0.1;
    scene.max_ticks = 600;
    Learner learner = anticipationLearner();
    CrowdDecider decider(learner);
    Episode episode(scene, 0, learner.model().vision());
    std::set<AgentId> by_robot;
    while (!episode.isOver()) {
      if (episode.world().tick() % 20 == 0) {
        episode.robots().command(0, {{random.uniform(0.0, 0.8), 0.0}, random.uniform(-1.0, 1.0)});
      }
      if (!episode.walk(decider)) break;
      for (const RobotContact& contact : episode.world().robots()[0].contacts) {
        EXPECT_NE(contact.cause, ContactCause::PERSON) << "seed " << seed << ", agent " << contact.agent;
        by_robot.insert(contact.agent);
      }
      for (const Agent& agent : episode.world().agents()) {
        const bool reacts = agent.isHeldBy(Hold::REACTION) || agent.paceOf(Pace::REACTION) != 1.0;
        if (reacts && agent.id < scene.agents.size()) reacted.insert(scene.agents[agent.id].reaction);
      }
    }
    const EpisodeResult result = episode.result();
    for (AgentId id = 0; id < result.agents.size(); ++id) {
      EXPECT_TRUE(!result.agents[id].touched || by_robot.count(id) > 0) << "seed " << seed << ", agent " << id;
    }
  }
  EXPECT_EQ(reacted.size(), 4U);
}

TEST(Activities, ThreadsDoNotMatter) {
  std::vector<std::vector<double>> paths;
  for (const unsigned threads : {1U, 3U}) {
    KeyedRandom random(7, KeyedRandom::CONTENT, {});
    ThreadPool pool(threads);
    Episode episode(straight_walk::sceneOf(hall(random, "alarms: [{time: 40, area: all, sink: nearest}]\n"), 100.0, 7),
                    0, Vision(), pool);
    std::vector<double>& path = paths.emplace_back();
    while (!episode.isOver()) {
      straight_walk::step(episode);
      for (const Agent& agent : episode.world().agents()) {
        path.insert(path.end(), {agent.pose.position.x(), agent.pose.position.y(), agent.pose.heading});
      }
    }
  }
  EXPECT_EQ(paths[0], paths[1]);
}

}  // namespace
}  // namespace crowd::activities_property_test
