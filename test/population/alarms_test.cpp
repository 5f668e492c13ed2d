#include "population/alarms.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scenario/writing/scene_document.h"
#include "support/error_of.h"
#include "support/straight_walk.h"

namespace crowd::alarms_test {
namespace {

using straight_walk::episodeOf;
using straight_walk::step;
using straight_walk::walkUntil;

/// Agents of 1 m/s: one waits at (2, 0) from 2 s on, one is at the head of a queue at (2, 5) from 2 s on, and one
/// walks to the right at y = 20.
constexpr const char* PEOPLE =
    "agents:\n"
    "  - {position: [0, 0], route: stay, speed: 1, radius: 0.2}\n"
    "  - {position: [0, 5], route: buy, speed: 1, radius: 0.2}\n"
    "  - {position: [0, 20], goal: [90, 20], speed: 1, radius: 0.2}\n"
    "routes:\n"
    "  stay: {waypoints: [{place: [2, 0], wait: 99}, {sink: west}]}\n"
    "  buy: {waypoints: [{queue: till}, {sink: west}]}\n"
    "queues: {till: {head: [2, 5], direction: 180, spacing: 1, service: 99}}\n"
    "sinks: {west: {area: [-20, 0]}, east: {area: [10, 0]}}\n";

AlarmDescription alarm(const Episode& episode, const std::string& sink, double factor = 1.0) {
  AlarmDescription description;
  description.speed_factor = factor;
  if (!sink.empty()) description.route = alarmRoute(sinkWaypoint(sink, episode.scene().population->sinks));
  return description;
}

Region box(const Vector2& low, const Vector2& high) {
  Region region;
  region.kind = Region::Kind::BOX;
  region.first = low;
  region.second = high;
  return region;
}

/// At 2 m/s it takes 4 s from (2, 0) to (10, 0).
TEST(Alarms, PeopleWalkToTheNearestSinkAtOnce) {
  Episode episode =
      episodeOf(std::string(PEOPLE) + "alarms: [{time: 10, area: all, sink: nearest, speed_factor: 2}]\n");
  const auto& agents = episode.world().agents();
  walkUntil(9.5, episode);
  EXPECT_TRUE(agents[0].isHeldBy(Hold::ROUTE));
  EXPECT_EQ(agents[1].pose.position, Vector2(2.0, 5.0));
  EXPECT_EQ(agents[0].max_speed, 1.0);
  step(episode);
  for (AgentId id = 0; id < 3; ++id) {
    EXPECT_FALSE(agents[id].isHeld()) << id;
    EXPECT_EQ(agents[id].goal(), Vector2(10.0, 0.0)) << id;
    EXPECT_EQ(agents[id].wanted_speed, 2.0) << id;
  }
  EXPECT_TRUE(episode.population().queue(0).line().empty());
  walkUntil(100.0, episode);
  EXPECT_EQ(episode.result().arrivedCount(), 3U);
  // The pace holds from the end of the first tick on, in which it walks 0.5 m: 7.5 m at 2 m/s are 8 ticks.
  EXPECT_EQ(agents[0].arrival_tick, 20U + 1U + 8U);
}

TEST(Alarms, AtTheStart) {
  Episode episode = episodeOf(std::string(PEOPLE) + "alarms: [{time: 0, area: all, sink: east}]\n");
  for (const Agent& agent : episode.world().agents()) EXPECT_EQ(agent.goal(), Vector2(10.0, 0.0));
}

TEST(Alarms, TheWayCounts) {
  Episode episode =
      episodeOf(std::string(PEOPLE) + "walls: [[[5, -40], [5, 40]]]\nalarms: [{time: 3, area: all, sink: nearest}]\n");
  walkUntil(3.0, episode);
  EXPECT_EQ(episode.world().agents()[0].goal(), Vector2(-20.0, 0.0));
}

TEST(Alarms, OnlyInAnArea) {
  Episode episode = episodeOf(std::string(PEOPLE) +
                              "alarms: [{time: 3, area: {box: [[0, 4], [9, 6]]}, sink: west, speed_factor: 1.5}]\n");
  const auto& agents = episode.world().agents();
  walkUntil(4.0, episode);
  EXPECT_TRUE(agents[0].isHeld());
  EXPECT_EQ(agents[1].goal(), Vector2(-20.0, 0.0));
  EXPECT_EQ(agents[1].max_speed, 1.5);
  EXPECT_EQ(agents[2].goal(), Vector2(90.0, 20.0));
  EXPECT_EQ(agents[2].max_speed, 1.0);
}

TEST(Alarms, WithoutASinkPeopleOnlyChangeTheirSpeed) {
  Episode episode = episodeOf(std::string(PEOPLE) + "alarms: [{time: 3, area: all, speed_factor: 0.5}]\n");
  walkUntil(5.0, episode);
  const auto& agents = episode.world().agents();
  EXPECT_TRUE(agents[0].isHeld());
  EXPECT_EQ(agents[2].goal(), Vector2(90.0, 20.0));
  EXPECT_EQ(agents[2].pose.position, Vector2(3.5 + 1.5 * 0.5, 20.0));
}

/// The alarm at 3 s; it stands until 8 s, and walks 8 m.
TEST(Alarms, ReactionTimes) {
  Episode episode = episodeOf(std::string(PEOPLE) + "alarms: [{time: 3, area: all, sink: east, reaction_time: 5}]\n");
  const auto& agents = episode.world().agents();
  walkUntil(7.5, episode);
  EXPECT_EQ(agents[2].pose.position, Vector2(3.0, 20.0));
  EXPECT_TRUE(agents[0].isHeld());
  walkUntil(100.0, episode);
  EXPECT_EQ(agents[0].arrival_tick, 2U * 16U);
}

/// Two sources at regular intervals; that with the middle in the area ends.
TEST(Alarms, SourcesEnd) {
  const std::string sources =
      "sinks: {out: {area: [99, 0]}}\n"
      "sources:\n"
      "  - {area: [0, 0], rate: 1, interval: regular, count: 20, goal: [90, 0], speed: 1, radius: 0.2}\n"
      "  - {area: [0, 9], rate: 1, interval: regular, count: 20, goal: [90, 9], speed: 1, radius: 0.2}\n";
  const auto count_after = [&](const std::string& keys) {
    Episode episode = episodeOf(sources + "alarms: [{time: 5, " + keys + "}]\n");
    walkUntil(50.0, episode);
    return episode.world().enteredCount();
  };
  EXPECT_EQ(count_after("area: all, sink: out"), 2U * 5U);  // at 0 to 4 s
  EXPECT_EQ(count_after("area: all, sink: out, keep_sources: true"), 2U * 20U);
  EXPECT_EQ(count_after("area: all, speed_factor: 2"), 2U * 20U);
  EXPECT_EQ(count_after("area: {box: [[-1, -1], [1, 1]]}, sink: out"), 5U + 20U);
}

TEST(Alarms, NobodyStopsAtAttractionsAnyMore) {
  Episode episode = episodeOf(
      std::string(PEOPLE) +
      "attractions: {window: {area: [1, 20], radius: 1, share: 1, wait: 99}, stall: {area: [5, 1], radius: 5, share: "
      "1, wait: 99}}\nalarms: [{time: 5, area: all, sink: east}]\n");
  walkUntil(4.5, episode);
  EXPECT_TRUE(episode.world().agents()[2].isHeldBy(Hold::ATTRACTION));
  walkUntil(100.0, episode);
  EXPECT_EQ(episode.result().arrivedCount(), 3U);
  EXPECT_LT(episode.world().time(), 40.0);
}

TEST(Alarms, TheHurryOfAgentsAndSources) {
  Episode episode = episodeOf(
      "agents: [{position: [0, 0], goal: [30, 0], speed: 1, hurry: 1.5, radius: 0.2}]\n"
      "sources: [{area: [0, 9], times: [0], goal: [30, 9], speed: 1, hurry: [1.2, 1.4], radius: 0.2}]\n");
  const auto& agents = episode.world().agents();
  EXPECT_EQ(agents[0].max_speed, 1.5);
  EXPECT_GE(agents[1].max_speed, 1.2);
  EXPECT_LT(agents[1].max_speed, 1.4);
  EXPECT_EQ(agents[1].own_speed, 1.0);
  EXPECT_EQ(episode.edit().raiseAlarm(alarm(episode, "", 0.5)), 2U);  // in place of `hurry`
  walkUntil(1.0, episode);
  EXPECT_EQ(agents[0].max_speed, 0.5);
}

std::vector<Vector2> placesOf(Episode& episode) {
  std::vector<Vector2> places;
  while (!episode.isOver()) {
    step(episode);
    for (const Agent& agent : episode.world().agents()) places.push_back(agent.pose.position);
  }
  return places;
}

/// Raised by a request and by the scenario.
TEST(Alarms, BothWaysAreTheSame) {
  Episode by_scenario =
      episodeOf(std::string(PEOPLE) + "alarms: [{time: 5, area: all, sink: nearest, speed_factor: 1.5}]\n");
  walkUntil(5.0, by_scenario);
  Episode by_request = episodeOf(PEOPLE);
  walkUntil(5.0, by_request);
  EXPECT_EQ(by_request.edit().raiseAlarm(alarm(by_request, "nearest", 1.5)), 3U);
  EXPECT_EQ(placesOf(by_request), placesOf(by_scenario));
}

TEST(Alarms, ASavedSceneBeginsWithThem) {
  Episode episode = episodeOf(PEOPLE);
  walkUntil(5.0, episode);
  AlarmDescription raised = alarm(episode, "east", 1.5);
  raised.area = box({0.0, 4.0}, {9.0, 6.0});
  EXPECT_EQ(episode.edit().raiseAlarm(raised), 1U);
  const std::string document = toDocument(episode.scene(), ".");
  const std::string expected =
      "alarms:\n  - {time: 0, area: {box: [[0, 4], [9, 6]]}, sink: 'east', speed_factor: 1.5}\n";
  EXPECT_EQ(document.substr(document.find("alarms:")), expected);
}

TEST(Alarms, RefusedOnesChangeNothing) {
  Episode episode = episodeOf(PEOPLE);
  walkUntil(5.0, episode);
  const auto refusal = [&](auto change) {
    AlarmDescription wrong = alarm(episode, "nearest");
    change(wrong);
    return errorOf<InputError>([&] { episode.edit().raiseAlarm(wrong); });
  };
  EXPECT_EQ(refusal([](auto& wrong) { wrong.speed_factor = 0.0; }), "speed_factor: expected a number above 0, got '0'");
  EXPECT_EQ(refusal([](auto& wrong) { wrong.speed_factor = 11.0; }), "speed_factor: expected at most 10, got '11'");
  EXPECT_EQ(refusal([](auto& wrong) { wrong.area = box({1.0, 0.0}, {0.0, 1.0}); }).substr(0, 8), "area.box");
  EXPECT_EQ(errorOf<InputError>([&] { alarm(episode, "wst"); }),
            "there is no sink 'wst', did you mean 'west'? Known are west, east");
  EXPECT_TRUE(episode.scene().population->alarms.empty());
  EXPECT_TRUE(episode.world().agents()[0].isHeld());
}

TEST(Alarms, NobodyBecomesTooFast) {
  Episode episode = episodeOf("agents: [{position: [0, 0], goal: [9000, 0], speed: 200, radius: 0.2}]\n");
  const std::string message = errorOf<InputError>([&] { episode.edit().raiseAlarm(alarm(episode, "", 6.0)); });
  EXPECT_EQ(message, "speed_factor: expected one with which agent 0 walks at most 1000 m/s, got 6");
  EXPECT_EQ(episode.world().agents()[0].wanted_speed, 200.0);
}

}  // namespace
}  // namespace crowd::alarms_test
