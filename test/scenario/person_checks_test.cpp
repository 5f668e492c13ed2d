#include "scenario/reading/person_checks.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scenario/reading/scenario_files.h"
#include "support/scenario_texts.h"

namespace crowd::person_checks_test {
namespace {

using scenario_texts::HEAD;

std::vector<std::string> warningsOf(const std::string& keys) {
  return parseScenarios(HEAD + keys, "s.yaml").warnings();
}

std::string agent(const std::string& entries) {
  return "agents:\n  - {position: [0, 0], goal: [40, 30], " + entries + "}\n";
}

TEST(PersonChecks, NamesEachUnlikelyValueOnceWithItsPlace) {
  EXPECT_EQ(
      warningsOf(agent("speed: 130, radius: [0.25, 20]") +
                 "sources:\n  - {area: [90, 90], goal: [99, 99], rate: 1, count: 1, speed: 1, radius: 0.01}\n"),
      (std::vector<std::string>{
          "s.yaml: document 1, line 5: agents[0].speed: no person has '130'; expected a number from 0.01 to 12 m/s",
          "s.yaml: document 1, line 5: agents[0].radius: no person has '20'; expected a number from 0.05 to 1.5 m",
          "s.yaml: document 1, line 7: sources[0].radius: no person has '0.01'; expected a number from 0.05 to 1.5 "
          "m"}));
  EXPECT_EQ(warningsOf(agent("kind: runner") + "kinds:\n  runner: {speed: [1, 13], radius: 0.2}\n"),
            (std::vector<std::string>{"s.yaml: document 1, line 7: kind 'runner'.speed: no person has '13'; expected a "
                                      "number from 0.01 to 12 m/s"}));
}

TEST(PersonChecks, LikelyPeopleAndThesisUnitsAreFine) {
  EXPECT_TRUE(warningsOf(agent("speed: 12, radius: [0.05, 1.5]")).empty());
  EXPECT_TRUE(warningsOf("units: thesis\n" + agent("speed: 50, radius: 20")).empty());
}

TEST(PersonChecks, ScenariosOfThePackageGiveNoWarning) {
  for (const std::string& name : scenarioNames()) {
    EXPECT_EQ(readScenarios(findScenario(name)).warnings(), std::vector<std::string>()) << name;
  }
}

}  // namespace
}  // namespace crowd::person_checks_test
