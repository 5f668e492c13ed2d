#include "common/text/suggestions.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/text/quotes.h"

namespace crowd {
namespace {

constexpr std::size_t MAX_EDITS = 2;

/// Returns the distance of two names if they are near; nullopt if not, or if their lengths differ too much for that.
std::optional<std::size_t> nearDistance(std::string_view given, std::string_view known) {
  const std::size_t shorter = std::min(given.size(), known.size());
  const std::size_t longer = std::max(given.size(), known.size());
  const std::size_t limit = std::min(MAX_EDITS, longer / 2);
  if (longer - shorter > limit) return std::nullopt;
  const std::size_t distance = editDistance(given, known);
  return distance <= limit ? std::optional<std::size_t>(distance) : std::nullopt;
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
  std::vector<std::pair<std::size_t, std::string>> by_distance;
  by_distance.reserve(known.size());
  for (std::string& name : known) {
    const std::size_t distance = editDistance(given, name);
    by_distance.emplace_back(distance, std::move(name));
  }
  std::stable_sort(by_distance.begin(), by_distance.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::transform(by_distance.begin(), by_distance.end(), known.begin(),
                 [](auto& entry) { return std::move(entry.second); });
  return known;
}

std::string nearestName(std::string_view given, const std::vector<std::string>& known) {
  std::string nearest;
  std::size_t least = MAX_EDITS + 1;
  for (const std::string& name : known) {
    const std::optional<std::size_t> distance = nearDistance(given, name);
    if (!distance || *distance >= least) continue;
    nearest = name;
    least = *distance;
  }
  return nearest;
}

std::string didYouMean(std::string_view given, const std::vector<std::string>& known, const std::string& prefix) {
  const std::string nearest = nearestName(given, known);
  return nearest.empty() ? "" : ", did you mean '" + prefix + nearest + "'?";
}

std::string joinNames(const std::vector<std::string>& names, const std::string& prefix, std::size_t most) {
  std::string text;
  const std::size_t shown = std::min(names.size(), most);
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) text += ", ";
    text.append(prefix).append(shortened(names[i]));
  }
  return text + (shown < names.size() ? " and " + std::to_string(names.size() - shown) + " more" : "");
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
