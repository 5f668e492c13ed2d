// Errors of scenario files tell nothing of what the files contain while quotes are hidden.

#include <gtest/gtest.h>

#include <cctype>
#include <string>

#include "common/files/files.h"
#include "common/text/quotes.h"
#include "scenario/reading/scenario_files.h"
#include "scenario/reading/scenario_reader.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"

namespace crowd::hidden_scenarios_test {
namespace {

constexpr const char* SECRET = "sEcReT";

bool isPartOfWord(char letter) { return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_'; }

/// A scenario with everything that has a name.
constexpr const char* NAMES = R"(name: names
duration: 60
goal_tolerance: 0.3
agents:
  - {position: [0, 0], route: tour, speed: [0.5, 1.0], radius: 0.25, heading: random}
  - {position: {box: [[0, 4], [9, 9]]}, count: 2, goal: {ring: {centre: [0, 7], radius: 1}}, speed: 1, radius: 0.2}
sources: [{area: [0, 15], rate: 1, route: tour, speed: 1, radius: 0.2}, {area: [0, 12], times: [1, 2], goal: [9, 12], speed: 1, radius: 0.2}]
sinks: {way_out: {box: [[8, 1], [9, 2]]}}
queues: {till: {head: [6, 0], direction: 90, spacing: 0.8, service: [1, 2]}}
gates: {door: {wall: [[20, 0], [20, 1]], open: [[0, 1]]}}
routes: {tour: {waypoints: [{place: [3, 0], wait: 1}, {queue: till}, {one_of: [{place: [4, 2]}, {place: [4, 3]}]}, {sink: way_out}]}}
obstacles: [{position: [5, 30], radius: 0.4, waypoints: [[6, 30], [6, 31]], speed: 0.7}]
walls: [[[-3, -3], [-3, 3]]]
robots:
  - {name: tug, position: [30, 0], goal: [36, 0], radius: 0.3, max_speed: 1, drive: differential, yields: crowd}
  - {name: cart, position: [30, 5], goal: [36, 5], radius: 0.3, max_speed: 1, sensors: {scan: {range: 5}}}
)";

/// Replaces each word of a text in turn and checks the error. Returns the number of errors.
int checkAllWords(const std::string& text, const std::string& name) {
  int errors = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = begin;
    while (end < text.size() && isPartOfWord(text[end])) ++end;
    if (end == begin) {
      ++begin;
      continue;
    }
    const std::string changed = text.substr(0, begin) + SECRET + text.substr(end);
    begin = end;
    const HiddenQuotes hidden;
    const std::string problem = errorOf<Error>([&] { parseScenarios(changed, name); });
    EXPECT_FALSE(contains(problem, SECRET)) << problem;
    errors += problem == "no error" ? 0 : 1;
  }
  return errors;
}

TEST(HiddenScenarios, NoWordIsInAnError) { EXPECT_GT(checkAllWords(NAMES, "names.yaml"), 150); }

TEST(HiddenScenarios, NoWordOfShippedScenariosIsInAnError) {
  for (const char* const name : {"twins_a", "line6_mover", "circle12_varied", "robot_door", "corridor_two_way"}) {
    const std::string file = findScenario(name);
    EXPECT_GT(checkAllWords(readFile(file), file), 20) << name;
  }
}

TEST(HiddenScenarios, ThePlaceAndWhatIsExpectedAreTold) {
  const HiddenQuotes hidden;
  const auto problem_of = [](const char* text) {
    return errorOf<InputError>([&] { parseScenarios(text, "file.yaml"); });
  };
  EXPECT_EQ(problem_of("root:x:0:0:root:/root:/bin/bash\n"),
            "file.yaml: document 1, line 1: expected a map, got '...'");
  EXPECT_EQ(problem_of("name: a\npassword: secret\n").substr(0, 60),
            "file.yaml: document 1, line 2: unknown key '...'; known are ");
  EXPECT_EQ(problem_of("name: a\nduration: secret\n"),
            "file.yaml: document 1, line 2: duration: expected a number above 0, got '...'");
}

TEST(HiddenScenarios, NamesOfOthersAreQuotedOtherwise) {
  EXPECT_TRUE(contains(errorOf<InputError>([] { parseScenarios("secret", "file.yaml"); }), "got 'secret'"));
}

}  // namespace
}  // namespace crowd::hidden_scenarios_test
