#include <gtest/gtest.h>

#include <string>

#include "scenario/population_spec.h"
#include "scenario/region_geometry.h"
#include "support/scenario_texts.h"

namespace crowd::population_reader_test {
namespace {

using scenario_texts::AGENTS;
using scenario_texts::expectNear;
using scenario_texts::HEAD;

using Kind = WaypointDescription::Kind;

const char* const SHOP = R"(
agents:
  - {position: [0, 0], route: shopping, speed: 1.3, radius: 0.25, reaction_time: [10, 100]}
  - {position: [0, 5], goal: [4, 3], speed: 1.3, radius: 0.25, reaction_time: 3}
routes:
  shopping:
    waypoints:
      - {place: {box: [[0, 0], [4, 2]]}, wait: [5, 20]}
      - {queue: till}
      - {one_of: [{place: [1, 2]}, {place: [3, 4], wait: 2}]}
      - {sink: exit_a}
  rounds: {repeat: true, waypoints: [{place: [1, 1]}, {place: [2, 2]}]}
  flight: {waypoints: [{sink: nearest}]}
sources:
  - {area: {box: [[0, 0], [1, 2]]}, rate: 0.5, interval: regular, from: 3, until: 60, count: 100, goal: [9, 9], speed: [1, 1.5], radius: 0.2}
  - {area: [7, 7], times: [1.0, 2.5, 2.5], route: flight, speed: 1, radius: 0.2}
sinks:
  exit_a: {area: {box: [[10, 0], [11, 2]]}}
  exit_b: {area: {ring: {centre: [0, 0], radius: 1}}}
queues:
  till: {head: [3, 2], direction: 180, spacing: 0.6, service: [5, 20]}
gates:
  door: {wall: [[2, 0], [3, 0]], open: true}
  barrier: {wall: [[5, 0], [6, 0]], open: [[10, 20], [40, 60]]}
)";

Scenario shop() { return parseScenarios(std::string(HEAD) + SHOP, "s.yaml")[0]; }

TEST(PopulationReader, ReadsRoutes) {
  const Scenario scenario = shop();
  const PopulationDescription& population = *scenario.population;
  ASSERT_EQ(namesOf(population.routes), (std::vector<std::string>{"shopping", "rounds", "flight"}));
  const RouteDescription& shopping = population.routes[0];
  ASSERT_EQ(shopping.waypoints.size(), 4U);
  EXPECT_FALSE(shopping.repeat);
  EXPECT_EQ(shopping.waypoints[0].kind, Kind::PLACE);
  EXPECT_EQ(shopping.waypoints[0].place.second, Vector2(4.0, 2.0));
  EXPECT_EQ(shopping.waypoints[0].wait.low, 5.0);
  EXPECT_EQ(shopping.waypoints[0].wait.high, 20.0);
  EXPECT_EQ(shopping.waypoints[1].kind, Kind::QUEUE);
  ASSERT_EQ(shopping.waypoints[2].kind, Kind::ONE_OF);
  ASSERT_EQ(shopping.waypoints[2].alternatives.size(), 2U);
  EXPECT_EQ(shopping.waypoints[2].alternatives[1].place.first, Vector2(3.0, 4.0));
  EXPECT_EQ(shopping.waypoints[2].alternatives[1].wait.low, 2.0);
  EXPECT_EQ(shopping.waypoints[3].kind, Kind::SINK);
  EXPECT_EQ(shopping.waypoints[3].target, 0U);
  EXPECT_TRUE(population.routes[1].repeat);
  EXPECT_EQ(population.routes[2].waypoints[0].kind, Kind::NEAREST_SINK);
}

TEST(PopulationReader, ReadsSources) {
  const Scenario scenario = shop();
  const auto& sources = scenario.population->sources;
  ASSERT_EQ(sources.size(), 2U);
  EXPECT_EQ(sources[0].rate, 0.5);
  EXPECT_TRUE(sources[0].regular);
  EXPECT_EQ(sources[0].from, 3.0);
  EXPECT_EQ(sources[0].until, 60.0);
  EXPECT_EQ(sources[0].count, 100U);
  EXPECT_EQ(sources[0].agents.goals.at(0).first, Vector2(9.0, 9.0));
  EXPECT_EQ(sources[0].agents.max_speed.high, 1.5);
  EXPECT_EQ(sources[1].times, (std::vector<double>{1.0, 2.5, 2.5}));
  EXPECT_EQ(sources[1].agents.route, 2U);
}

TEST(PopulationReader, ReadsSinksQueuesAndGates) {
  const Scenario scenario = shop();
  const PopulationDescription& population = *scenario.population;
  EXPECT_EQ(namesOf(population.sinks), (std::vector<std::string>{"exit_a", "exit_b"}));
  EXPECT_EQ(population.sinks[0].area.second, Vector2(11.0, 2.0));
  const QueueDescription& till = population.queues.at(0);
  expectNear(till.place(0), {3.0, 2.0});
  expectNear(till.place(2), {1.8, 2.0});
  EXPECT_EQ(till.service.high, 20.0);
  const GateDescription& door = population.gates.at(0);
  EXPECT_EQ(door.wall.to, Vector2(3.0, 0.0));
  EXPECT_TRUE(door.isOpen(0.0));
  EXPECT_TRUE(door.isOpen(1e6));
  const GateDescription& barrier = population.gates.at(1);
  for (const double open : {10.0, 19.9, 40.0}) EXPECT_TRUE(barrier.isOpen(open)) << open;
  for (const double closed : {0.0, 9.9, 20.0, 39.9, 60.0}) EXPECT_FALSE(barrier.isOpen(closed)) << closed;
}

TEST(PopulationReader, ReadsRoutesAndReactionTimesOfAgents) {
  const Scene scene = shop().instantiate(1, 0);
  EXPECT_EQ(scene.agents[0].route, 0U);
  EXPECT_GE(scene.agents[0].reaction_time, 10.0);
  EXPECT_LT(scene.agents[0].reaction_time, 100.0);
  EXPECT_FALSE(scene.agents[1].route);
  EXPECT_EQ(scene.agents[1].reaction_time, 3.0);
}

TEST(PopulationReader, UnitsOfTheThesisHoldForSpeedsOfSources) {
  const Scenario scenario =
      parseScenarios(std::string(HEAD) + "units: thesis\n" + AGENTS +
                         "sources: [{area: [9, 9], times: [2], goal: [1, 9], speed: 0.03, radius: 0.2}]\n",
                     "s.yaml")[0];
  EXPECT_NEAR(scenario.population->sources[0].agents.max_speed.low, 0.3, 1e-12);
}

TEST(PopulationReader, AScenarioWithSourcesNeedsNoAgents) {
  const Scenario scenario = parseScenarios(
      std::string(HEAD) + "sources: [{area: [0, 0], rate: 1, goal: [4, 0], speed: 1, radius: 0.2}]\n", "s.yaml")[0];
  EXPECT_TRUE(scenario.agents.empty());
  EXPECT_EQ(scenario.population->sources[0].count, std::numeric_limits<std::uint64_t>::max());
}

TEST(PopulationReader, AScenarioWithoutTheseKeysHasNone) {
  EXPECT_EQ(parseScenarios(std::string(HEAD) + AGENTS, "s.yaml")[0].population, nullptr);
}

/// What is drawn during an episode does not depend on what is drawn before it, and differs between episodes.
TEST(PopulationReader, EachEpisodeHasItsSeed) {
  const Scenario scenario = shop();
  EXPECT_EQ(scenario.instantiate(1, 0).population_seed, scenario.instantiate(1, 0).population_seed);
  EXPECT_NE(scenario.instantiate(1, 0).population_seed, scenario.instantiate(1, 1).population_seed);
  EXPECT_NE(scenario.instantiate(1, 0).population_seed, scenario.instantiate(2, 0).population_seed);
}

TEST(RegionGeometry, NearestPointsAndInnerRegions) {
  Region box;
  box.kind = Region::Kind::BOX;
  box.first = {0.0, 0.0};
  box.second = {4.0, 1.0};
  EXPECT_EQ(nearestPoint(box, {5.0, 0.5}), Vector2(4.0, 0.5));
  EXPECT_TRUE(contains(box, {4.0, 0.5}));
  EXPECT_FALSE(contains(box, {4.1, 0.5}));
  const Region inner = shrink(box, 0.75);
  expectNear(inner.first, {0.75, 0.5});
  expectNear(inner.second, {3.25, 0.5});
  Region ring;
  ring.kind = Region::Kind::RING;
  ring.radius = {1.0, 2.0};
  expectNear(nearestPoint(ring, {0.0, 5.0}), {0.0, 2.0});
  expectNear(nearestPoint(ring, {0.5, 0.0}), {1.0, 0.0});
  EXPECT_FALSE(contains(ring, {0.5, 0.0}));
  for (const Vector2& point : gridPoints(ring, 0.25)) EXPECT_TRUE(contains(ring, point));
  EXPECT_EQ(gridPoints(box, 0.5).size(), 27U);
}

}  // namespace
}  // namespace crowd::population_reader_test
