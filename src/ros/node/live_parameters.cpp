#include "ros/node/live_parameters.h"

#include <algorithm>
#include <array>

#include "common/text/numbers.h"
#include "common/text/quotes.h"
#include "common/text/suggestions.h"

namespace crowd {
namespace {

std::string textOf(const LiveValue& value) {
  if (const bool* const flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const int* const whole = std::get_if<int>(&value)) return std::to_string(*whole);
  if (const double* const number = std::get_if<double>(&value)) return toText(*number);
  return inQuotes(std::get<std::string>(value));
}

std::string expectedOf(const NumberRange& range, double number) { return range.contains(number) ? "" : toText(range); }

std::string expectedOf(const std::vector<std::string>& choices, const std::string& text) {
  const bool is_one = choices.empty() || std::count(choices.begin(), choices.end(), text) > 0;
  return is_one ? "" : joinAlternatives(choices);
}

/// Returns what is wrong with a new value; empty: nothing.
std::string problemOf(const LiveDescription& about, const LiveValue& wanted, const LiveValue& present) {
  if (wanted == present) return "";
  std::string expected;
  if (const int* const whole = std::get_if<int>(&wanted)) expected = expectedOf(about.range, *whole);
  if (const double* const number = std::get_if<double>(&wanted)) expected = expectedOf(about.range, *number);
  if (const auto* const text = std::get_if<std::string>(&wanted)) expected = expectedOf(about.choices, *text);
  if (wanted.index() != present.index()) expected = "a value of type " + typeOf(present);
  return expected.empty() ? "" : "expected " + expected + ", got " + textOf(wanted);
}

}  // namespace

std::string typeOf(const LiveValue& value) {
  constexpr std::array<const char*, std::variant_size_v<LiveValue>> NAMES{"bool", "int", "double", "str"};
  return NAMES.at(value.index());
}

void applyChanges(const std::vector<LiveDescription>& parameters, const LiveChanges& changes, LiveValues& values) {
  LiveValues changed = values;
  std::string problems;
  const auto take = [&](const std::string& name, LiveValue wanted) -> std::string {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const LiveDescription& about) { return about.name == name; });
    if (found == parameters.end()) return "there is no such parameter";
    LiveValue& place = changed[static_cast<std::size_t>(found - parameters.begin())];
    const int* const whole = std::get_if<int>(&wanted);
    if (whole != nullptr && std::holds_alternative<double>(place)) wanted = static_cast<double>(*whole);
    std::string problem = problemOf(*found, wanted, place);
    place = std::move(wanted);
    return problem;
  };
  for (const auto& [name, wanted] : changes) {
    const std::string problem = take(name, wanted);
    if (!problem.empty()) problems += (problems.empty() ? "" : "; ") + shortened(name) + ": " + problem;
  }
  if (!problems.empty()) throw InputError(problems);
  values = std::move(changed);
}

}  // namespace crowd
