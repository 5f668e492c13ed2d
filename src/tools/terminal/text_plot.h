#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace crowd {

/// @brief A picture of dots made of the Braille patterns of Unicode: each character has 2 x 4 dots. A character without
/// dots is a blank.
class DotCanvas {
 public:
  /// @param columns, rows size in characters
  DotCanvas(std::size_t columns, std::size_t rows);

  std::size_t width() const { return 2 * columns_; }  ///< number of dots
  std::size_t height() const { return 4 * rows_; }    ///< number of dots
  /// @brief Sets a dot; (0, 0) is at the top left. A dot outside of the picture is left out.
  void set(std::size_t x, std::size_t y);
  /// @brief Returns a row of characters in UTF-8.
  std::string line(std::size_t row) const;

 private:
  std::size_t columns_;
  std::size_t rows_;
  std::vector<std::uint8_t> cells_;  // the dots of each character as bits of its code point
};

/// @brief A curve in a panel with a title and two labels of its vertical axis.
struct PlotPanel {
  std::string title;
  std::vector<double> values;  ///< from left to right, resampled to the dots of the panel; NaN: a gap
  double last = std::numeric_limits<double>::quiet_NaN();  ///< printed beside the title; NaN: nothing
  /// Ends of the axis; NaN: the lowest or highest value.
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

/// @brief Width of the labels of a panel in characters, its vertical line included.
constexpr int PANEL_LABELS = 8;

/// @brief Draws a panel: a line with title and last value, then `rows` - 1 lines with axis and curve.
/// @param columns, rows size in characters; at least PANEL_LABELS + 2 columns and 3 rows
/// @return `rows` lines of `columns` characters in UTF-8
std::vector<std::string> drawPanel(const PlotPanel& panel, int columns, int rows);

/// @brief A number in at most six characters: 0.123, 98.2, 52489, 1.23M.
std::string shortNumber(double value);

}  // namespace crowd
