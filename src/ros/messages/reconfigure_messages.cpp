#include "social_crowd/ros/messages/reconfigure_messages.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "social_crowd/common/errors.h"
#include "social_crowd/common/quotes.h"

namespace crowd {
namespace {

constexpr const char* GROUP = "Default";
constexpr double INSIDE = 1e-6;  // distance of a shown limit from an open one

void append(const std::string& name, const LiveValue& value, dynamic_reconfigure::Config& message) {
  const auto append_to = [&](auto& list, const auto& content) {
    list.emplace_back();
    list.back().name = name;
    list.back().value = content;
  };
  if (const bool* const flag = std::get_if<bool>(&value)) append_to(message.bools, *flag ? 1 : 0);
  if (const int* const whole = std::get_if<int>(&value)) append_to(message.ints, *whole);
  if (const double* const number = std::get_if<double>(&value)) append_to(message.doubles, *number);
  if (const auto* const text = std::get_if<std::string>(&value)) append_to(message.strs, *text);
}

std::string typeOf(const LiveValue& value) {
  constexpr std::array<const char*, std::variant_size_v<LiveValue>> NAMES{"bool", "int", "double", "str"};
  return NAMES.at(value.index());
}

/// The lowest or highest value of a parameter. Clients take the limits for permitted values: an open one is moved
/// inside.
LiveValue limitOf(const LiveValue& value, const NumberRange& range, bool highest) {
  const double limit =
      highest ? range.high - (range.below_high ? INSIDE : 0.0) : range.low + (range.above_low ? INSIDE : 0.0);
  if (std::holds_alternative<bool>(value)) return highest;
  if (std::holds_alternative<int>(value)) return static_cast<int>(limit);
  if (std::holds_alternative<double>(value)) return limit;
  return std::string();
}

/// A Python expression from which clients make a list of the choices; empty without choices.
std::string editMethod(const LiveDescription& about) {
  std::ostringstream entries;
  for (const std::string& choice : about.choices) {
    entries << "{'name': '" << choice << "', 'value': '" << choice << "', 'type': 'str', 'ctype': 'std::string', "
            << "'cconsttype': 'const char * const', 'description': '', 'srcfile': '', 'srcline': 0}, ";
  }
  return about.choices.empty() ? "" : "{'enum': [" + entries.str() + "], 'enum_description': ''}";
}

/// Returns the value of a request as one of the type of the parameter, if it can be.
LiveValue converted(const LiveValue& wanted, const LiveValue& present) {
  const int* const whole = std::get_if<int>(&wanted);
  return whole != nullptr && std::holds_alternative<double>(present) ? LiveValue(static_cast<double>(*whole)) : wanted;
}

/// Returns what is wrong with a value of a request; empty: nothing.
std::string problemOf(const LiveDescription& about, const LiveValue& wanted, const LiveValue& present) {
  if (wanted == present) return "";
  if (wanted.index() == present.index()) return problemOf(about, wanted);
  return "expected a value of type " + typeOf(present) + ", got " + toText(wanted);
}

}  // namespace

dynamic_reconfigure::Config toMessage(const std::vector<LiveDescription>& parameters, const LiveValues& values) {
  dynamic_reconfigure::Config message;
  for (std::size_t i = 0; i < parameters.size(); ++i) append(parameters[i].name, values[i], message);
  message.groups.emplace_back();
  message.groups.front().name = GROUP;
  message.groups.front().state = 1;
  return message;
}

dynamic_reconfigure::ConfigDescription toDescription(const std::vector<LiveDescription>& parameters,
                                                     const LiveValues& defaults) {
  dynamic_reconfigure::ConfigDescription message;
  message.groups.emplace_back();
  message.groups.front().name = GROUP;
  LiveValues lowest;
  LiveValues highest;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    dynamic_reconfigure::ParamDescription about;
    about.name = parameters[i].name;
    about.type = typeOf(defaults[i]);
    about.description = parameters[i].meaning;
    about.edit_method = editMethod(parameters[i]);
    message.groups.front().parameters.push_back(about);
    lowest.push_back(limitOf(defaults[i], parameters[i].range, false));
    highest.push_back(limitOf(defaults[i], parameters[i].range, true));
  }
  message.dflt = toMessage(parameters, defaults);
  message.min = toMessage(parameters, lowest);
  message.max = toMessage(parameters, highest);
  return message;
}

void takeRequest(const dynamic_reconfigure::Config& request, const std::vector<LiveDescription>& parameters,
                 LiveValues& values) {
  LiveValues wanted = values;
  std::string problems;
  const auto note = [&](const std::string& name, const std::string& problem) {
    if (!problem.empty()) problems += (problems.empty() ? "" : "; ") + name + ": " + problem;
  };
  const auto take_one = [&](const std::string& name, const LiveValue& value) {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const LiveDescription& about) { return about.name == name; });
    if (found == parameters.end()) return note(shortened(name), "there is no such parameter");
    LiveValue& place = wanted[static_cast<std::size_t>(found - parameters.begin())];
    const LiveValue fitting = converted(value, place);
    note(name, problemOf(*found, fitting, place));
    place = fitting;
  };
  for (const auto& entry : request.bools) take_one(entry.name, entry.value != 0);
  for (const auto& entry : request.ints) take_one(entry.name, static_cast<int>(entry.value));
  for (const auto& entry : request.doubles) take_one(entry.name, entry.value);
  for (const auto& entry : request.strs) take_one(entry.name, entry.value);
  if (!problems.empty()) throw InputError(problems);
  values = std::move(wanted);
}

}  // namespace crowd
