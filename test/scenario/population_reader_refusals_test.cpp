#include <gtest/gtest.h>

#include <string>

#include "social_crowd/errors.h"
#include "support/scenario_texts.h"

namespace crowd::population_reader_refusals_test {
namespace {

using scenario_texts::AGENTS;
using scenario_texts::errorOf;
using scenario_texts::HEAD;

/// What is said of a scenario with one agent, and these keys from line 5 on.
std::string errorIn(const std::string& keys) { return errorOf(std::string(HEAD) + AGENTS + keys + "\n"); }

void says(const std::string& keys, const std::string& expected) {
  EXPECT_EQ(errorIn(keys), "s.yaml: document 1, line 5: " + expected) << keys;
}

/// The same for a source with these entries changed or added.
void sourceSays(const std::string& entries, const std::string& expected) {
  says("sources: [{area: [9, 9], goal: [1, 9], speed: 1, radius: 0.2, " + entries + "}]", expected);
}

TEST(PopulationRefusals, Sources) {
  sourceSays("rate: 1, rat: 2",
             "sources[0]: unknown key 'rat', did you mean 'rate'? Known are area, rate, times, interval, from, until, "
             "count, goal, goals, route, kind, speed, radius, groups");
  sourceSays("count: 3", "sources[0]: expected either rate or times, got neither");
  sourceSays("rate: 1, times: [1]", "sources[0]: expected either rate or times, got both");
  sourceSays("rate: -1", "sources[0].rate: expected a number above 0, got '-1'");
  sourceSays("rate: 0", "sources[0].rate: expected a number above 0, got '0'");
  sourceSays("rate: .inf", "sources[0].rate: expected a number above 0, got '.inf'");
  sourceSays("rate: 1, interval: often", "sources[0].interval: expected exponential or regular, got 'often'");
  sourceSays("rate: 1, from: -1", "sources[0].from: expected a number of 0 or more, got '-1'");
  sourceSays("rate: 1, from: 5, until: 5", "sources[0].until: expected a time after `from`, 5 s");
  sourceSays("rate: 1, count: 0", "sources[0].count: expected a whole number from 1 to 1000000000, got '0'");
  sourceSays("times: [1, 3, 2]", "sources[0].times[2]: expected ascending times, got 2 after 3");
  sourceSays("times: []", "sources[0].times: expected at least one time, got a list of 0");
  sourceSays("times: [-1]", "sources[0].times[0]: expected a number of 0 or more, got '-1'");
  sourceSays("times: [1], until: 9", "sources[0].until: goes with rate only");
  sourceSays("rate: 1, route: home", "sources[0]: expected only one of goal, goals and route");
  says("sources: [{area: [9, 9], rate: 1, goal: [1, 9], speed: -1, radius: 0.2}]",
       "sources[0].speed: expected a number above 0, got '-1'");
  says("sources: [{rate: 1, goal: [1, 9], speed: 1, radius: 0.2}]", "sources[0]: the key 'area' is missing");
  says("sources: [{area: [9, 9], rate: 1, speed: 1, radius: 0.2}]", "sources[0]: the key 'goal' is missing");
}

TEST(PopulationRefusals, UnknownNames) {
  says(
      "sources: [{area: [9, 9], rate: 1, route: hom, speed: 1, radius: 0.2}]\n"
      "routes: {home: {waypoints: [{place: [1, 1]}]}, away: {waypoints: [{place: [1, 1]}]}}",
      "sources[0].route: there is no route 'hom', did you mean 'home'? Known are home, away");
  says("routes: {home: {waypoints: [{sink: way_out}]}}",
       "routes.home.waypoints[0].sink: there is no sink 'way_out'; the scenario has no sinks");
  says("routes: {home: {waypoints: [{sink: nearest}]}}", "routes.home.waypoints[0].sink: the scenario has no sinks");
  says(
      "routes: {home: {waypoints: [{queue: tll}]}}\n"
      "queues: {till: {head: [1, 1], direction: 0, spacing: 1, service: 1}}",
      "routes.home.waypoints[0].queue: there is no queue 'tll', did you mean 'till'? Known are till");
  EXPECT_EQ(errorOf(std::string(HEAD) + "agents: [{position: [0, 0], route: home, speed: 1.3, radius: 0.25}]\n"),
            "s.yaml: document 1, line 4: agents[0].route: there is no route 'home'; the scenario has no routes");
}

TEST(PopulationRefusals, Routes) {
  says("routes: {home: {waypoints: []}}", "routes.home.waypoints: expected at least one waypoint, got a list of 0");
  says("routes: {home: {}}", "routes.home: the key 'waypoints' is missing");
  says("routes: {home: {waypoints: [{place: [1, 1]}], repeats: true}}",
       "routes.home: unknown key 'repeats', did you mean 'repeat'? Known are repeat, waypoints");
  says("routes: {home: {waypoints: [{wait: 3}]}}",
       "routes.home.waypoints[0]: expected one of place, queue, one_of and sink");
  says("routes: {home: {waypoints: [{place: [1, 1], sink: out}]}}",
       "routes.home.waypoints[0]: expected one of place, queue, one_of and sink");
  says("routes: {home: {waypoints: [{place: [1, 1], wait: -1}]}}",
       "routes.home.waypoints[0].wait: expected a number of 0 or more, got '-1'");
  says("routes: {home: {waypoints: [{one_of: []}]}}",
       "routes.home.waypoints[0].one_of: expected at least one waypoint, got a list of 0");
  says("routes: {home: {waypoints: [{one_of: [{one_of: [{place: [1, 1]}]}]}]}}",
       "routes.home.waypoints[0].one_of[0]: expected a place, queue or sink, got another one_of");
  const std::string sinks = "\nsinks: {out: {area: [5, 5]}}";
  says("routes: {home: {waypoints: [{sink: out, wait: 2}]}}" + sinks,
       "routes.home.waypoints[0].wait: a wait goes with a place only");
  says("routes: {home: {waypoints: [{sink: out}, {place: [1, 1]}]}}" + sinks,
       "routes.home.waypoints[0]: expected a sink as the last waypoint only");
  says("routes: {home: {repeat: true, waypoints: [{place: [1, 1]}, {sink: out}]}}" + sinks,
       "routes.home.waypoints[1]: a route that repeats has no sink");
  says("routes: [{waypoints: []}]", "routes: expected a map, got a list of 1");
}

TEST(PopulationRefusals, SinksQueuesAndGates) {
  says("sinks: {out: {area: {map: free}}}", "sinks.out.area: expected [x, y], {box: ...} or {ring: ...}, got a map");
  says("sinks: {out: {}}", "sinks.out: the key 'area' is missing");
  says("sinks: {out: {area: [1, 1]}, out: {area: [2, 2]}}", "sinks: the key 'out' stands twice");
  says("queues: {till: {head: [1, 1], direction: 0, spacing: 0, service: 1}}",
       "queues.till.spacing: expected a number above 0, got '0'");
  says("queues: {till: {head: [1, 1], direction: 0, spacing: 1, service: [3, 1]}}",
       "queues.till.service: expected [low, high], got the higher number first");
  says("gates: {door: {wall: [[2, 0], [2, 0]], open: true}}",
       "gates.door.wall: expected a wall with a length, got twice the same end");
  says("gates: {door: {wall: [[2, 0], [3, 0]], open: yes}}",
       "gates.door.open: expected true, false, or a list of periods [[begin, end], ...], got 'yes'");
  says("gates: {door: {wall: [[2, 0], [3, 0]], open: [[1, 3], [2, 4]]}}",
       "gates.door.open[1]: expected ascending periods, got one that begins before the last one ends");
  says("gates: {door: {wall: [[2, 0], [3, 0]], open: [[3, 1]]}}",
       "gates.door.open[0]: expected [begin, end] with the earlier time first");
  says("gates: {door: {wall: [[2, 0], [3, 0]]}}", "gates.door: the key 'open' is missing");
}

TEST(PopulationRefusals, PlacesInWalls) {
  const std::string box =
      "\nwalls: [[[8, 8], [8.3, 8]], [[8.3, 8], [8.3, 8.3]], [[8.3, 8.3], [8, 8.3]], [[8, 8.3], [8, 8]]]";
  says(
      "sources: [{area: {box: [[8, 8], [8.3, 8.3]]}, rate: 1, goal: [1, 9], speed: 1, radius: 0.2}]" + box,
      "sources[0].area: expected a place where an agent of radius 0.2 m fits, got only such in walls or nearer to one");
  says("sources: [{area: [1, 9], rate: 1, goal: [8.1, 8.1], speed: 1, radius: 0.2}]" + box,
       "sources[0].goal: expected a place where an agent of radius 0.2 m fits, got one in a wall or nearer to one");
  says("routes: {home: {waypoints: [{one_of: [{place: [1, 1]}, {place: [8, 8]}]}]}}" + box,
       "routes.home.waypoints[0].one_of[1].place: expected a place where an agent of radius 0.25 m fits, got one in a "
       "wall or nearer to one");
  says(
      "sinks: {out: {area: {box: [[8, 8], [8.3, 8.3]]}}}" + box,
      "sinks.out.area: expected a place where an agent of radius 0.25 m fits, got only such in walls or nearer to one");
  says("queues: {till: {head: [8.1, 8.1], direction: 0, spacing: 1, service: 1}}" + box,
       "queues.till.head: expected a place where an agent of radius 0.25 m fits, got one in a wall or nearer to one");
  EXPECT_EQ(errorIn("sources: [{area: {box: [[8, 8], [9, 9]]}, rate: 1, goal: [1, 9], speed: 1, radius: 0.2}]" + box),
            "no InputError");
}

TEST(PopulationRefusals, AScenarioNeedsAgentsOrSources) {
  EXPECT_EQ(errorOf(std::string(HEAD) + "sinks: {out: {area: [1, 1]}}\n"),
            "s.yaml: document 1, line 1: the key 'agents' is missing");
  EXPECT_EQ(errorOf(std::string(HEAD) + "agents: []\n"),
            "s.yaml: document 1, line 4: agents: expected at least one agent, got a list of 0");
}

TEST(PopulationRefusals, ReactionTimes) {
  EXPECT_EQ(scenario_texts::agentError("position: [0, 0], goal: [1, 1], speed: 1, radius: 0.2, reaction_time: -1"),
            "s.yaml: document 1, line 5: agents[0].reaction_time: expected a number of 0 or more, got '-1'");
}

}  // namespace
}  // namespace crowd::population_reader_refusals_test
