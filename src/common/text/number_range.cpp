#include "common/text/number_range.h"

#include "common/text/numbers.h"

namespace crowd {

std::string toText(const NumberRange& range) {
  const bool has_low = std::isfinite(range.low);
  const bool has_high = std::isfinite(range.high);
  std::string text = "a number";
  if (has_low && range.above_low) {
    text += " above " + toText(range.low);
    if (has_high) text += std::string(range.below_high ? ", below " : ", at most ") + toText(range.high);
  } else if (has_low && has_high) {
    text += " from " + toText(range.low) + (range.below_high ? " to below " : " to ") + toText(range.high);
  } else if (has_low) {
    text += " of at least " + toText(range.low);
  } else if (has_high) {
    text += std::string(range.below_high ? " below " : " of at most ") + toText(range.high);
  }
  return *range.unit == '\0' ? text : text + " " + range.unit;
}

}  // namespace crowd
