#include "scenario/reading/person_checks.h"

#include "common/text/number_range.h"
#include "common/text/numbers.h"
#include "common/text/quotes.h"
#include "scenario/population_spec.h"

namespace crowd {
namespace {

constexpr NumberRange PERSON_SPEED{0.01, 12.0, "m/s"};  // the fastest sprinters reach 12 m/s
constexpr NumberRange PERSON_RADIUS{0.05, 1.5, "m"};

class PersonCheck {
 public:
  explicit PersonCheck(const Scenario& scenario) : scenario_(scenario) {}

  void check(const AgentGroup& group, const std::string& field) {
    const std::string place = placeText(scenario_.source, group.line, field);
    if (!group.speed_of_kind) require(group.max_speed, PERSON_SPEED, place + ".speed");
    if (!group.radius_of_kind) require(group.radius, PERSON_RADIUS, place + ".radius");
  }
  void check(const PersonKind& kind) {
    const std::string place = placeText(kind.source, kind.line, "kind " + inQuotes(kind.name));
    require(kind.speed.range, PERSON_SPEED, place + ".speed");
    require(kind.radius, PERSON_RADIUS, place + ".radius");
  }
  std::vector<std::string> take() { return std::move(warnings_); }

 private:
  static std::string placeText(const std::string& source, int line, const std::string& field) {
    return source + ", line " + std::to_string(line) + ": " + field;
  }
  void require(const Range& found, const NumberRange& expected, const std::string& place) {
    const bool is_low_wrong = !expected.contains(found.low);
    if (!is_low_wrong && expected.contains(found.high)) return;
    const double wrong = is_low_wrong ? found.low : found.high;
    warnings_.push_back(place + ": no person has " + inQuotes(toText(wrong)) + "; expected " + toText(expected));
  }

  const Scenario& scenario_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::vector<std::string> findUnlikelyPeople(const Scenario& scenario) {
  PersonCheck people(scenario);
  for (std::size_t i = 0; i < scenario.agents.size(); ++i) {
    people.check(scenario.agents[i], "agents[" + std::to_string(i) + "]");
  }
  if (!scenario.population) return people.take();
  const std::vector<SourceDescription>& sources = scenario.population->sources;
  for (std::size_t i = 0; i < sources.size(); ++i)
    people.check(sources[i].agents, "sources[" + std::to_string(i) + "]");
  for (const PersonKind& kind : scenario.population->kinds) people.check(kind);
  return people.take();
}

}  // namespace crowd
