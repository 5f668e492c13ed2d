#include "social_crowd/common/suggestions.h"

#include <algorithm>

namespace crowd {
namespace {

constexpr std::size_t MAX_EDITS = 2;

bool isNear(std::string_view given, std::string_view known) {
  const std::size_t limit = std::min(MAX_EDITS, std::max(given.size(), known.size()) / 2);
  return editDistance(given, known) <= limit;
}

}  // namespace

std::size_t editDistance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> before_last;
  std::vector<std::size_t> last;
  std::vector<std::size_t> row(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    before_last = std::move(last);
    last = row;
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool exchanged = i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1];
      if (exchanged) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[to.size()];
}

std::vector<std::string> sortedByNearness(std::string_view given, std::vector<std::string> known) {
  std::stable_sort(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
    return editDistance(given, a) < editDistance(given, b);
  });
  return known;
}

std::string nearestName(std::string_view given, const std::vector<std::string>& known) {
  const std::vector<std::string> sorted = sortedByNearness(given, known);
  const auto nearest =
      std::find_if(sorted.begin(), sorted.end(), [&](const std::string& name) { return isNear(given, name); });
  return nearest == sorted.end() ? "" : *nearest;
}

std::string didYouMean(std::string_view given, const std::vector<std::string>& known, const std::string& prefix) {
  const std::string nearest = nearestName(given, known);
  return nearest.empty() ? "" : ", did you mean '" + prefix + nearest + "'?";
}

std::string joinNames(const std::vector<std::string>& names, const std::string& prefix) {
  std::string text;
  for (const std::string& name : names) {
    if (!text.empty()) text += ", ";
    text.append(prefix).append(name);
  }
  return text;
}

std::string joinAlternatives(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " or ";
    text += names[i];
  }
  return text;
}

}  // namespace crowd
