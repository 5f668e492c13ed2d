#include "social_crowd/ros/controller/live_parameters.h"

#include <algorithm>

#include "social_crowd/common/numbers.h"
#include "social_crowd/common/quotes.h"
#include "social_crowd/common/suggestions.h"

namespace crowd {
namespace {

std::string expectedOf(const LiveDescription& about, double number) {
  return about.range.contains(number) ? "" : toText(about.range);
}

std::string expectedOf(const LiveDescription& about, const std::string& text) {
  const std::vector<std::string>& choices = about.choices;
  if (choices.empty() || std::count(choices.begin(), choices.end(), text) > 0) return "";
  return joinAlternatives(choices);
}

}  // namespace

std::string toText(const LiveValue& value) {
  if (const bool* const flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const int* const whole = std::get_if<int>(&value)) return std::to_string(*whole);
  if (const double* const number = std::get_if<double>(&value)) return toText(*number);
  return inQuotes(std::get<std::string>(value));
}

std::string problemOf(const LiveDescription& about, const LiveValue& value) {
  std::string expected;
  if (const int* const whole = std::get_if<int>(&value)) expected = expectedOf(about, *whole);
  if (const double* const number = std::get_if<double>(&value)) expected = expectedOf(about, *number);
  if (const auto* const text = std::get_if<std::string>(&value)) expected = expectedOf(about, *text);
  return expected.empty() ? "" : "expected " + expected + ", got " + toText(value);
}

}  // namespace crowd
