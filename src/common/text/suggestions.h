#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Error messages about unknown names.
namespace crowd {

/// @brief Returns the optimal string alignment distance: the number of letters to insert, delete, replace or exchange
/// with the next one.
std::size_t editDistance(std::string_view from, std::string_view to);

/// @brief Returns the known name nearest to the given one, within two edits and half of its letters; the first of equal
/// ones. Empty if there is none.
std::string nearestName(std::string_view given, const std::vector<std::string>& known);

/// @brief Returns ", did you mean 'NAME'?" with a prefix before the name; empty if no known name is near.
std::string didYouMean(std::string_view given, const std::vector<std::string>& known, const std::string& prefix = "");

/// @brief Returns the known names, nearest to the given one first.
std::vector<std::string> sortedByNearness(std::string_view given, std::vector<std::string> known);

/// @brief Returns the names, each with a prefix, separated by commas. Very long ones are shortened.
/// @param most number of names beyond which the others are only counted
std::string joinNames(const std::vector<std::string>& names, const std::string& prefix = "", std::size_t most = 200);

/// @brief Returns "a, b or c".
std::string joinAlternatives(const std::vector<std::string>& names);

}  // namespace crowd
