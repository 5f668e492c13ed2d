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
             "count, goal, goals, route, kind, speed, hurry, radius, groups, reaction");
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

TEST(PopulationRefusals, Faces) {
  const auto stop = [](const std::string& entries) {
    return "routes: {home: {waypoints: [{place: [1, 1], " + entries + "}]}}";
  };
  const std::string field = "routes.home.waypoints[0].face: ";
  says(stop("wait: 3, face: up"), field + "expected a number, got 'up'");
  says(stop("wait: 3, face: {robt: rob}"), field + "expected degrees, [x, y] or {robot: NAME}, got a map");
  says(stop("wait: 3, face: [1]"), field + "expected [x, y], got a list of 1");
  says(stop("face: 90"), field + "a face goes with a wait only");
  says(stop("wait: 3, face: {robot: rob}"),
       "routes.home.waypoints[0].face.robot: there is no robot 'rob'; the scenario has no robots");
  says("queues: {till: {head: [1, 1], direction: 0, spacing: 1, service: 1, face: {robot: rob}}}",
       "queues.till.face.robot: there is no robot 'rob'; the scenario has no robots");
  says("routes: {home: {waypoints: [{sink: out, face: 90}]}}\nsinks: {out: {area: [5, 5]}}",
       "routes.home.waypoints[0].face: a face goes with a place only");
}

TEST(PopulationRefusals, Attractions) {
  const auto window = [](const std::string& entries) { return "attractions: {window: {" + entries + "}}"; };
  says(window("radius: 3, share: 1, wait: 1"), "attractions.window: the key 'area' is missing");
  says(window("area: [9, 9], radius: 0, share: 1, wait: 1"),
       "attractions.window.radius: expected a number above 0, got '0'");
  says(window("area: [9, 9], radius: 3, share: 1.1, wait: 1"),
       "attractions.window.share: expected a number from 0 to 1, got '1.1'");
  says(window("area: [9, 9], radius: 3, share: 1"), "attractions.window: the key 'wait' is missing");
  says(window("area: {map: free}, radius: 3, share: 1, wait: 1"),
       "attractions.window.area: expected [x, y], {box: ...} or {ring: ...}, got a map");
  says(window("area: [9, 9], radius: 3, share: 1, wait: 1, face: {robot: rob}"),
       "attractions.window.face.robot: there is no robot 'rob'; the scenario has no robots");
  says(window("area: [9, 9], radius: 3, share: 1, wait: 1") + "\nwalls: [[[8, 9], [10, 9]]]",
       "attractions.window.area: expected a place where an agent of radius 0.25 m fits, got one in a wall or nearer to "
       "one");
}

TEST(PopulationRefusals, Alarms) {
  const auto alarm = [](const std::string& entries) { return "alarms: [{" + entries + "}]"; };
  const std::string sinks = "\nsinks: {out: {area: [5, 5]}}";
  says(alarm("area: all"), "alarms[0]: the key 'time' is missing");
  says(alarm("time: 1"), "alarms[0]: the key 'area' is missing");
  says(alarm("time: 1, area: everywhere"), "alarms[0].area: expected all, {box: ...} or {ring: ...}, got 'everywhere'");
  says(alarm("time: 1, area: [1, 1]"), "alarms[0].area: expected all, {box: ...} or {ring: ...}, got a list of 2");
  says(alarm("time: 1, area: all, sink: nearest"), "alarms[0].sink: the scenario has no sinks");
  says(alarm("time: 1, area: all, sink: ot") + sinks,
       "alarms[0].sink: there is no sink 'ot', did you mean 'out'? Known are out");
  says(alarm("time: 1, area: all, speed_factor: 0"), "alarms[0].speed_factor: expected a number above 0, got '0'");
  says(alarm("time: 1, area: all, speed_factor: 10.5"), "alarms[0].speed_factor: expected at most 10, got '10.5'");
  says(alarm("time: 1, area: all, reaction_time: 3"), "alarms[0].reaction_time: goes with a sink only");
  says(alarm("time: 1, area: all, keep_sources: true"), "alarms[0].keep_sources: goes with a sink only");
  says(alarm("time: 1, area: all, speed_factor: 6") +
           "\nsources: [{area: [9, 9], rate: 1, goal: [1, 9], speed: 200, radius: 0.2}]",
       "alarms[0].speed_factor: expected one with which agents walk at most 1000 m/s, got 6");
}

TEST(PopulationRefusals, Hurry) {
  const std::string person = "position: [0, 0], goal: [1, 1], speed: 200, radius: 0.2, ";
  const std::string field = "s.yaml: document 1, line 5: agents[0].";
  EXPECT_EQ(scenario_texts::agentError(person + "hurry: 0"), field + "hurry: expected a number above 0, got '0'");
  EXPECT_EQ(scenario_texts::agentError(person + "hurry: [2, 1]"),
            field + "hurry: expected [low, high], got the higher number first");
  EXPECT_EQ(scenario_texts::agentError(person + "hurry: [1, 6]"),
            field + "hurry: expected a factor with which `speed` is at most 1000 m/s, got a list of 2");
  EXPECT_EQ(scenario_texts::agentError(person + "hurry: 0.5, velocity: [0, 150]"),
            field + "velocity: expected a velocity of at most `speed` times `hurry`, got a list of 2");
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
