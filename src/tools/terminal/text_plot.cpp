#include "tools/terminal/text_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/text/numbers.h"

namespace crowd {
namespace {

/// The bits of the dots of a Braille pattern, by column and row.
constexpr std::array<std::array<std::uint8_t, 4>, 2> DOT_BITS = {{{0x01, 0x02, 0x04, 0x40}, {0x08, 0x10, 0x20, 0x80}}};

/// A Braille pattern in UTF-8: U+2800 and its bits.
std::string brailleOf(std::uint8_t bits) {
  return {'\xE2', static_cast<char>(0xA0U | bits >> 6U), static_cast<char>(0x80U | (bits & 0x3FU))};
}

std::string blanks(std::size_t count) { return std::string(count, ' '); }

/// Right-aligned in `width` characters, or cut.
std::string aligned(const std::string& text, std::size_t width) {
  return blanks(width - std::min(width, text.size())) + text.substr(0, width);
}

struct Axis {
  double low = 0.0;
  double high = 1.0;
};

/// The given ends of the axis, or else those of the values; never empty.
Axis axisOf(const PlotPanel& panel) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : panel.values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) low = high = 0.0;
  if (!std::isnan(panel.low)) low = panel.low;
  if (!std::isnan(panel.high)) high = panel.high;
  return high > low ? Axis{low, high} : Axis{low, low + 1.0};
}

/// Draws the curve; neighbouring values are connected by vertical lines.
void drawCurve(const std::vector<double>& values, const Axis& axis, DotCanvas& canvas) {
  const auto bottom = static_cast<double>(canvas.height() - 1);
  const auto row_of = [&](double value) {
    const double share = std::clamp((axis.high - value) / (axis.high - axis.low), 0.0, 1.0);
    return static_cast<std::size_t>(std::lround(share * bottom));
  };
  bool connects = false;
  std::size_t before = 0;
  for (std::size_t x = 0; x < canvas.width(); ++x) {
    const double value = values.empty() ? NAN : values[x * values.size() / canvas.width()];
    if (!std::isfinite(value)) {
      connects = false;
      continue;
    }
    const std::size_t y = row_of(value);
    canvas.set(x, y);
    if (connects) {
      for (std::size_t between = std::min(y, before) + 1; between < std::max(y, before); ++between) {
        canvas.set(x, between);
      }
    }
    before = y;
    connects = true;
  }
}

}  // namespace

DotCanvas::DotCanvas(std::size_t columns, std::size_t rows) : columns_(columns), rows_(rows), cells_(columns * rows) {}

void DotCanvas::set(std::size_t x, std::size_t y) {
  if (x < width() && y < height()) cells_[y / 4 * columns_ + x / 2] |= DOT_BITS.at(x % 2).at(y % 4);
}

std::string DotCanvas::line(std::size_t row) const {
  std::string text;
  for (std::size_t column = 0; column < columns_; ++column) {
    const std::uint8_t bits = cells_[row * columns_ + column];
    text += bits == 0 ? " " : brailleOf(bits);
  }
  return text;
}

std::vector<std::string> drawPanel(const PlotPanel& panel, int columns, int rows) {
  constexpr std::size_t LABEL = PANEL_LABELS - 1;
  const auto width = static_cast<std::size_t>(std::max(columns, PANEL_LABELS + 2));
  const auto height = static_cast<std::size_t>(std::max(rows, 3)) - 1;
  const Axis axis = axisOf(panel);
  DotCanvas canvas(width - PANEL_LABELS, height);
  drawCurve(panel.values, axis, canvas);
  const std::size_t space = width - PANEL_LABELS;
  const std::string last = (std::isnan(panel.last) ? std::string() : shortNumber(panel.last)).substr(0, space);
  const std::string title = panel.title.substr(0, space - std::min(space, last.empty() ? 0 : last.size() + 1));
  std::vector<std::string> lines = {blanks(PANEL_LABELS) + title + aligned(last, space - title.size())};
  for (std::size_t row = 0; row < height; ++row) {
    const bool is_end = row == 0 || row + 1 == height;
    const std::string label = is_end ? shortNumber(row == 0 ? axis.high : axis.low) : "";
    lines.push_back(aligned(label, LABEL) + (is_end ? "┤" : "│") + canvas.line(row));
  }
  return lines;
}

std::string shortNumber(double value) {
  const double size = std::abs(value);
  if (size >= 9'999'999.5) return toFixedText(value / 1e6, 0) + "M";
  if (size >= 99'999.5) return toFixedText(value / 1e6, 2) + "M";
  if (value == std::floor(value) || size >= 999.95) return toFixedText(value, 0);
  if (size >= 9.9995) return toFixedText(value, 1);
  return toFixedText(value, 3);
}

}  // namespace crowd
