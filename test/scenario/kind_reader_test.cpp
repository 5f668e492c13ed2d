#include "scenario/reading/kind_reader.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "scenario/scenario.h"
#include "support/scenario_texts.h"
#include "support/temporary_folder.h"

namespace crowd::kind_reader_test {
namespace {

using scenario_texts::errorOf;
using scenario_texts::HEAD;
using scenario_texts::sceneOf;

/// A scenario with one agent of this kind, in line 4, and these keys.
std::string withKind(const std::string& kind, const std::string& keys = "") {
  return std::string(HEAD) + "agents: [{position: [0, 0], goal: [4, 3], kind: " + kind + "}]\n" + keys;
}

Scenario scenarioOf(const std::string& text) { return parseScenarios(text, "s.yaml")[0]; }

const char* const WAITER =
    "kinds:\n"
    "  waiter: {speed: {mean: 1.2, deviation: 0.1, range: [1, 1.5]}, radius: [0.2, 0.3], figure: old,"
    " pauses: {every: 20, duration: [3, 5], speed: 0.5}}\n"
    "  child: {speed: 0.9, radius: 0.15}\n"
    "  unused: {speed: 2, radius: 1}\n";

TEST(KindReader, ReadsEveryKey) {
  const Scenario scenario = scenarioOf(withKind("{waiter: 2, child: 1}", WAITER));
  const std::vector<PersonKind>& kinds = scenario.population->kinds;
  ASSERT_EQ(namesOf(kinds), (std::vector<std::string>{"waiter", "child"}));
  EXPECT_EQ(kinds[0].speed.normal->mean, 1.2);
  EXPECT_EQ(kinds[0].speed.normal->deviation, 0.1);
  EXPECT_EQ(kinds[0].speed.range.high, 1.5);
  EXPECT_EQ(kinds[0].figure, Figure::OLD);
  EXPECT_EQ(kinds[0].pauses->every, 20.0);
  EXPECT_EQ(kinds[0].pauses->duration.high, 5.0);
  EXPECT_EQ(kinds[0].pauses->speed, 0.5);
  EXPECT_FALSE(kinds[1].pauses);
  EXPECT_EQ(kinds[1].figure, Figure::ADULT);  // the scenario's child, not that of the package
  const AgentGroup& group = scenario.agents[0];
  ASSERT_EQ(group.kinds.size(), 2U);
  EXPECT_EQ(group.kinds[0].share, 2.0);
  EXPECT_EQ(group.max_speed.low, 0.9);
  EXPECT_EQ(group.max_speed.high, 1.5);
  EXPECT_EQ(group.radius.low, 0.15);
  EXPECT_EQ(group.radius.high, 0.3);
}

TEST(KindReader, KindsOfThePackageHaveTheirFigures) {
  const Scene scene = sceneOf(withKind("wheelchair"));
  EXPECT_EQ(scene.agents[0].figure, Figure::WHEELCHAIR);
  EXPECT_EQ(scene.agents[0].radius, 0.4);
  EXPECT_GE(scene.agents[0].max_speed, 0.13);
  EXPECT_LE(scene.agents[0].max_speed, 1.35);
}

TEST(KindReader, ValuesOfTheEntryReplaceThoseOfTheKind) {
  const Scene scene = sceneOf(std::string(HEAD) +
                              "agents: [{position: [0, 0], goal: [4, 3], kind: child, speed: 1.7, radius: 0.22}]\n");
  EXPECT_EQ(scene.agents[0].max_speed, 1.7);
  EXPECT_EQ(scene.agents[0].radius, 0.22);
  EXPECT_EQ(scene.agents[0].figure, Figure::CHILD);
}

TEST(KindReader, OnlySpeedsOfTheScenarioAreInItsUnits) {
  const std::string thesis = "units: thesis\ntick: 0.5\n";
  EXPECT_EQ(sceneOf(withKind("slow", thesis + "kinds: {slow: {speed: 0.4, radius: 0.2}}\n")).agents[0].max_speed, 0.8);
  EXPECT_LE(sceneOf(withKind("child", thesis)).agents[0].max_speed, 1.33);
}

TEST(KindReader, ReadsKindsFromAFile) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() + "/people.yaml") << "guard: {speed: 1.1, radius: 0.3}\nchild: {speed: 9, radius: 0.2}\n";
  std::ofstream(folder.path() + "/s.yaml") << withKind("guard", "kinds: people.yaml\n");
  EXPECT_EQ(readScenarios(folder.path() + "/s.yaml").scene(1, 0).agents[0].max_speed, 1.1);
  const std::string place = folder.path() + "/s.yaml: document 1, line 5: kinds: " + folder.path();
  std::ofstream(folder.path() + "/people.yaml") << "guard:\n  {speed: 1.1}\n";
  try {
    readScenarios(folder.path() + "/s.yaml");
    ADD_FAILURE() << "read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), place + "/people.yaml: line 2: guard: the key 'radius' is missing");
  }
}

TEST(KindReader, KindsThatNobodyHasChangeNothing) {
  const std::string crowd =
      std::string(HEAD) +
      "agents: [{count: 20, position: {box: [[-5, -5], [5, 5]]}, goal: {box: [[-5, -5], [5, 5]]}, "
      "speed: [1, 2], radius: [0.2, 0.3]}]\n";
  const Scene plain = sceneOf(crowd);
  const Scene with_kinds = sceneOf(crowd + WAITER);
  EXPECT_EQ(with_kinds.population, nullptr);
  for (std::size_t i = 0; i < plain.agents.size(); ++i) {
    EXPECT_EQ(with_kinds.agents[i].position, plain.agents[i].position);
    EXPECT_EQ(with_kinds.agents[i].max_speed, plain.agents[i].max_speed);
    EXPECT_EQ(with_kinds.agents[i].radius, plain.agents[i].radius);
  }
}

void says(const std::string& kind, const std::string& keys, const std::string& expected) {
  EXPECT_EQ(errorOf(withKind(kind, keys)), "s.yaml: document 1, line " + expected) << kind << keys;
}

void ownSays(const std::string& entries, const std::string& expected) {
  says("own", "kinds: {own: {" + entries + "}}\n", "5: kinds.own" + expected);
}

TEST(KindReader, RefusesWrongReactions) {
  const std::string names = "regular, indifferent, surprised, curious, scared, threatening";
  says("child, reaction: scarred", "",
       "4: agents[0].reaction: there is no reaction 'scarred', did you mean 'scared'? Known are " + names);
  says("child, reaction: {happy: 1}", "", "4: agents[0].reaction: there is no reaction 'happy'; known are " + names);
  says("child, reaction: {curious: -1}", "", "4: agents[0].reaction.curious: expected a number above 0, got '-1'");
  says("child, reaction: {}", "",
       "4: agents[0].reaction: expected the name of a reaction, or names and their shares {NAME: SHARE}, got a map");
}

TEST(KindReader, ReactionsShiftNoOtherDraws) {
  const std::string crowd =
      std::string(HEAD) + "agents: [{count: 20, position: {box: [[-5, -5], [5, 5]]}, goal: {box: [[-5, -5], [5, 5]]}, ";
  const Scene plain = sceneOf(crowd + "kind: {adult: 1, child: 1}}]\n");
  const Scene mixed = sceneOf(crowd + "kind: {adult: 1, child: 1}, reaction: {curious: 1, scared: 1}}]\n");
  for (std::size_t i = 0; i < plain.agents.size(); ++i) {
    EXPECT_EQ(mixed.agents[i].position, plain.agents[i].position);
    EXPECT_EQ(mixed.agents[i].kind, plain.agents[i].kind);
    EXPECT_EQ(plain.agents[i].reaction, Reaction::REGULAR);
    EXPECT_GE(mixed.agents[i].reaction, Reaction::CURIOUS);
  }
}

TEST(KindReader, RefusesWhatIsWrong) {
  says("chlid", "",
       "4: agents[0].kind: there is no kind 'chlid', did you mean 'child'? Known are adult, child, old, wheelchair, "
       "luggage, phone, phone_stop, rimea_under_30, rimea_30_to_50, rimea_over_50, rimea_limited_mobility");
  says("{child: 0}", "", "4: agents[0].kind.child: expected a number above 0, got '0'");
  says("{}", "", "4: agents[0].kind: expected the name of a kind, or names and their shares {NAME: SHARE}, got a map");
  says("[child]", "",
       "4: agents[0].kind: expected the name of a kind, or names and their shares {NAME: SHARE}, got a list of 1");
  ownSays("speed: 1", ": the key 'radius' is missing");
  ownSays("speed: 1, radius: 0.2, mass: 80", ": unknown key 'mass'; known are speed, radius, figure, pauses");
  ownSays("speed: {mean: 2, deviation: 1, range: [0.5, 1.5]}, radius: 0.2",
          ".speed.mean: expected a mean within the range, got '2'");
  ownSays("speed: {mean: 1, deviation: 1}, radius: 0.2", ".speed: the key 'range' is missing");
  ownSays("speed: 1, radius: 0.2, figure: dog",
          ".figure: expected adult, child, old, wheelchair or trolley, got 'dog'");
  ownSays("speed: 1, radius: 0.2, pauses: {every: 0, duration: 1}",
          ".pauses.every: expected a number above 0, got '0'");
  ownSays("speed: 1, radius: 0.2, pauses: {every: 9, duration: [0.001, 1]}",
          ".pauses.duration: expected at least 0.01 s, got a list of 2");
  ownSays("speed: 1, radius: 0.2, pauses: {every: 9}", ".pauses: the key 'duration' is missing");
  ownSays("speed: 1, radius: 0.2, pauses: {every: 9, duration: 1, speed: 2}",
          ".pauses.speed: expected a number from 0 to 1, got '2'");
}

}  // namespace
}  // namespace crowd::kind_reader_test
