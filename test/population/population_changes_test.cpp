#include "population/changes/population_changes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "simulation/episode.h"
#include "support/error_of.h"
#include "support/straight_walk.h"

namespace crowd::population_changes_test {
namespace {

using straight_walk::episodeOf;
using straight_walk::step;
using straight_walk::walkUntil;

constexpr const char* ALONE = "agents: [{position: [0, 0], goal: [90, 0], speed: 1, radius: 0.2}]\n";

Region at(double x, double y) {
  Region region;
  region.first = {x, y};
  return region;
}

/// An agent each second, at regular intervals, from (0, 5) to (4, 5).
SourceDescription source() {
  SourceDescription source;
  source.agents.position = at(0.0, 5.0);
  source.agents.goals = {at(4.0, 5.0)};
  source.agents.max_speed = {1.0, 1.0};
  source.agents.radius = {0.2, 0.2};
  source.rate = 1.0;
  source.regular = true;
  return source;
}

GateDescription gate() {
  GateDescription gate;
  gate.name = "door";
  gate.wall = {{2.0, -1.0}, {2.0, 1.0}};
  return gate;
}

TEST(PopulationChanges, ASourceBeginsWhenItIsAdded) {
  Episode episode = episodeOf(ALONE);
  walkUntil(10.0, episode);
  EXPECT_EQ(episode.edit().addSource(source()), 0U);
  EXPECT_EQ(episode.world().agents().size(), 1U);
  step(episode);  // half a second: the agent that was due at 10 s, and not those of the 10 s before
  EXPECT_EQ(episode.world().agents().size(), 2U);
  walkUntil(12.5, episode);
  ASSERT_EQ(episode.world().agents().size(), 4U);
  EXPECT_EQ(episode.world().agents()[1].goal(), Vector2(4.0, 5.0));
  ASSERT_TRUE(episode.scene().population);
  EXPECT_EQ(episode.scene().population->sources.at(0).from, 0.0);  // as in a scenario file
}

TEST(PopulationChanges, EarlierSourcesAndGatesGoOn) {
  Episode episode =
      episodeOf(std::string(ALONE) +
                "sources: [{area: [0, 9], rate: 1, interval: regular, goal: [4, 9], speed: 1, radius: 0.2}]\n"
                "gates: {first: {wall: [[50, 0], [50, 1]], open: [[3, 100]]}}\n");
  EXPECT_EQ(episode.edit().addSource(source()), 1U);
  episode.edit().addGate(gate());
  EXPECT_EQ(episode.world().walls().list().size(), 2U);
  walkUntil(2.0, episode);
  EXPECT_EQ(episode.world().agents().size(), 1U + 3U + 3U);  // due at 0, 1 and 2 s
  walkUntil(3.0, episode);
  EXPECT_EQ(episode.world().walls().list().size(), 1U);
}

TEST(PopulationChanges, AGateIsAWallUntilItIsOpened) {
  Episode episode = episodeOf(ALONE);
  episode.edit().addGate(gate());
  ASSERT_EQ(episode.world().walls().list().size(), 1U);
  EXPECT_TRUE(episode.edit().setGate("door", true));
  EXPECT_TRUE(episode.world().walls().list().empty());
  GateDescription later = gate();
  later.name = "later";
  later.open_in = std::vector<Period>{{0.0, 1.0}};
  episode.edit().addGate(later);
  EXPECT_TRUE(episode.world().walls().list().empty());
  walkUntil(1.0, episode);
  EXPECT_EQ(episode.world().walls().list().size(), 1U);
}

template <typename Change>
void expectRefused(const std::string& beginning, const Change& change) {
  Episode episode = episodeOf(std::string(ALONE) + "walls: [[[-5, 7], [5, 7]]]\n");
  const std::string message = errorOf<InputError>([&] { change(episode); });
  EXPECT_EQ(message.substr(0, beginning.size()), beginning) << message;
  EXPECT_FALSE(episode.scene().population && !episode.scene().population->empty());
}

TEST(PopulationChanges, RefusesWhatNoScenarioMayHave) {
  const auto add = [](auto change) {
    return [change](Episode& episode) {
      SourceDescription wrong = source();
      change(wrong);
      episode.edit().addSource(wrong);
    };
  };
  expectRefused("rate: expected", add([](auto& wrong) { wrong.rate = 0.0; }));
  expectRefused("rate: expected", add([](auto& wrong) { wrong.rate = NAN; }));
  expectRefused("speed: expected", add([](auto& wrong) { wrong.agents.max_speed = {-1.0, -1.0}; }));
  expectRefused("radius: expected", add([](auto& wrong) { wrong.agents.radius = {0.0, 0.0}; }));
  expectRefused("area", add([](auto& wrong) { wrong.agents.position = at(INFINITY, 5.0); }));
  expectRefused("area: expected a place", add([](auto& wrong) { wrong.agents.position = at(0.0, 6.9); }));
  expectRefused("goal: expected a place", add([](auto& wrong) { wrong.agents.goals = {at(0.0, 7.1)}; }));
}

/// A sink, the head of a queue and two routes in passages of 0.8 m; a walker of 0.2 m is on the first route.
constexpr const char* NARROW =
    "agents: [{position: [0, 0], route: used, speed: 1, radius: 0.2}]\n"
    "routes:\n"
    "  used: {waypoints: [{place: [20, 0]}, {sink: exit}]}\n"
    "  spare: {waypoints: [{place: [2, 5]}, {sink: exit}]}\n"
    "sinks: {exit: {area: [90, 0]}}\n";

/// Walls 0.4 m from a place, on both sides.
std::string wallsAt(double x, double y) {
  const auto wall = [&](double at) {
    return "[[" + std::to_string(x - 1.0) + ", " + std::to_string(at) + "], [" + std::to_string(x + 1.0) + ", " +
           std::to_string(at) + "]]";
  };
  return "walls: [" + wall(y - 0.4) + ", " + wall(y + 0.4) + "]\n";
}

SourceDescription sourceOfRadius(double radius, std::optional<std::size_t> route = std::nullopt) {
  SourceDescription wide = source();
  wide.agents.radius = {radius, radius};
  wide.agents.route = route;
  if (route) wide.agents.goals.clear();
  return wide;
}

TEST(PopulationChanges, RefusesAgentsThatDoNotFitWhereTheyMayGo) {
  const auto refusal = [](const std::string& walls, const std::string& way_finding, const SourceDescription& wide) {
    Episode episode = episodeOf(NARROW + walls + way_finding);
    return errorOf<InputError>([&] { episode.edit().addSource(wide); });
  };
  for (const std::string way_finding : {"", "way_finding: false\n"}) {
    SCOPED_TRACE(way_finding);
    EXPECT_EQ(
        refusal(wallsAt(90, 0), way_finding, sourceOfRadius(0.6)),
        "the scenario, line 9: sinks.exit.area: expected a place where an agent of radius 0.6 m fits, got one in a "
        "wall or nearer to one");
    EXPECT_TRUE(
        contains(refusal(wallsAt(20, 0), way_finding, sourceOfRadius(0.6, 0)), "routes.used.waypoints[0].place"));
    // Nobody is on this route yet: any agent may be sent there.
    EXPECT_TRUE(contains(refusal(wallsAt(2, 5), way_finding, sourceOfRadius(0.6)), "routes.spare.waypoints[0].place"));
    EXPECT_TRUE(contains(
        refusal("queues: {till: {head: [40, 0], direction: 180, spacing: 0.6, service: [5, 20]}}\n" + wallsAt(40, 0),
                way_finding, sourceOfRadius(0.6)),
        "queues.till.head"));
  }
}

TEST(PopulationChanges, AgentsMayBeTooLargeForRoutesOfOthers) {
  Episode episode = episodeOf(NARROW + wallsAt(20, 0));
  EXPECT_EQ(episode.edit().addSource(sourceOfRadius(0.6)), 0U);
}

TEST(PopulationChanges, AGateClosesWhenTheAgentInItHasLeft) {
  for (const std::string way_finding : {"", "way_finding: false\n"}) {
    SCOPED_TRACE(way_finding);
    Episode episode = episodeOf(ALONE + way_finding);
    GateDescription across = gate();
    across.wall = {{0.1, -1.0}, {0.1, 1.0}};
    episode.edit().addGate(across);
    EXPECT_TRUE(episode.world().walls().list().empty());
    walkUntil(1.0, episode);
    EXPECT_EQ(episode.world().walls().list().size(), 1U);
    GateDescription open = across;
    open.name = "open";
    open.open = true;
    open.wall = {{1.0, -1.0}, {1.0, 1.0}};
    episode.edit().addGate(open);
    EXPECT_EQ(episode.world().walls().list().size(), 1U);
  }
}

TEST(PopulationChanges, RefusesInvalidGates) {
  const auto add = [](auto change) {
    return [change](Episode& episode) {
      GateDescription wrong = gate();
      change(wrong);
      episode.edit().addGate(wrong);
    };
  };
  expectRefused("gate: expected a name", add([](auto& wrong) { wrong.name.clear(); }));
  expectRefused("wall", add([](auto& wrong) { wrong.wall.to = wrong.wall.from; }));
  expectRefused("wall", add([](auto& wrong) { wrong.wall.to.x() = NAN; }));
  expectRefused("open", add([](auto& wrong) { wrong.open_in = std::vector<Period>{{2.0, 1.0}}; }));
  expectRefused("open", add([](auto& wrong) { wrong.open_in = std::vector<Period>{{2.0, 4.0}, {3.0, 5.0}}; }));
  Episode episode = episodeOf(ALONE);
  episode.edit().addGate(gate());
  EXPECT_TRUE(contains(errorOf<InputError>([&] { episode.edit().addGate(gate()); }), "there is a gate 'door' already"));
}

}  // namespace
}  // namespace crowd::population_changes_test
