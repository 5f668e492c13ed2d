#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Error messages about unknown names.
namespace crowd {

/// @brief How many letters have to be inserted, left out, replaced or exchanged with the next one to get from one word
/// to the other (optimal string alignment distance).
std::size_t editDistance(std::string_view from, std::string_view to);

/// @brief The known name that the given one is most likely meant to be: at most two edits away, and at most half of
/// its letters; of several the first. Empty if there is none.
std::string nearestName(std::string_view given, const std::vector<std::string>& known);

/// @brief ", did you mean 'NAME'?" with a prefix before the name, or nothing if no known name is near.
std::string didYouMean(std::string_view given, const std::vector<std::string>& known, const std::string& prefix = "");

/// @brief The known names, the nearest to the given one first.
std::vector<std::string> sortedByNearness(std::string_view given, std::vector<std::string> known);

/// @brief The names with a prefix each and a comma between them.
std::string joinNames(const std::vector<std::string>& names, const std::string& prefix = "");

/// @brief Returns "a, b or c".
std::string joinAlternatives(const std::vector<std::string>& names);

}  // namespace crowd
