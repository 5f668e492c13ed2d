#include "common/text/number_limit.h"

#include <array>
#include <cmath>

#include "common/text/number_range.h"
#include "common/text/numbers.h"

namespace crowd {
namespace {

/// Words for the numbers that a rule permits, in the order of the rules.
constexpr std::array<const char*, 4> RULE_WORDS = {"a number", "a number of 0 or more", "a number above 0",
                                                   "a number from 0 to 1"};

bool satisfies(double value, NumberRule rule) {
  if (!std::isfinite(value)) return false;
  if (rule == NumberRule::ANY) return true;
  if (rule == NumberRule::POSITIVE) return value > 0.0;
  return value >= 0.0 && (rule == NumberRule::NOT_NEGATIVE || value <= 1.0);
}

}  // namespace

std::string refusalOf(double value, const NumberLimit& limit) {
  if (!satisfies(value, limit.rule)) return RULE_WORDS.at(static_cast<std::size_t>(limit.rule));
  if (std::abs(value) <= limit.most) return "";
  if (limit.rule == NumberRule::ANY) return toText(NumberRange{-limit.most, limit.most, limit.unit});
  return "at most " + toText(limit.most) + (*limit.unit == '\0' ? "" : " ") + limit.unit;
}

}  // namespace crowd
