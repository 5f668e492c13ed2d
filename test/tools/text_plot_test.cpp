#include "tools/terminal/text_plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace crowd::text_plot_test {
namespace {

using Lines = std::vector<std::string>;

TEST(DotCanvas, HasEightDotsInACharacter) {
  const auto drawn = [](std::size_t x, std::size_t y) {
    DotCanvas canvas(1, 1);
    canvas.set(x, y);
    return canvas.line(0);
  };
  EXPECT_EQ(DotCanvas(2, 1).line(0), "  ");
  const Lines left = {"⠁", "⠂", "⠄", "⡀"};
  const Lines right = {"⠈", "⠐", "⠠", "⢀"};
  for (std::size_t y = 0; y < 4; ++y) {
    EXPECT_EQ(drawn(0, y), left[y]);
    EXPECT_EQ(drawn(1, y), right[y]);
  }
  EXPECT_EQ(drawn(2, 0), " ");
  EXPECT_EQ(drawn(0, 4), " ");
}

TEST(DotCanvas, JoinsDots) {
  DotCanvas canvas(2, 2);
  for (std::size_t y = 0; y < 8; ++y) canvas.set(0, y);
  canvas.set(1, 3);
  canvas.set(3, 4);
  EXPECT_EQ(canvas.line(0), "⣇ ");
  EXPECT_EQ(canvas.line(1), "⡇⠈");
}

PlotPanel panel(std::vector<double> values, double low = NAN, double high = NAN) {
  PlotPanel panel;
  panel.title = "reward";
  panel.values = std::move(values);
  panel.last = panel.values.empty() ? NAN : panel.values.back();
  panel.low = low;
  panel.high = high;
  return panel;
}

/// Two characters of curve: four columns of eight dots, values 7 at the top to 0 at the bottom.
TEST(DrawPanel, DrawsADotForEachValue) {
  EXPECT_EQ(drawPanel(panel({7, 7, 7, 7}, 0, 7), 10, 3), (Lines{"         7",  //
                                                                "      7┤⠉⠉",  //
                                                                "      0┤  "}));
  EXPECT_EQ(drawPanel(panel({0, 1, 2, 3}, 0, 7), 10, 3)[2], "      0┤⡠⠊");
}

TEST(DrawPanel, ConnectsNeighbours) {
  // From 0 up to 7: the dots between are in the column of the second value.
  EXPECT_EQ(drawPanel(panel({0, 7, 7, 0}, 0, 7), 10, 3), (Lines{"         0",  //
                                                                "      7┤⢸⢱",  //
                                                                "      0┤⡸⢸"}));
}

TEST(DrawPanel, LeavesGaps) {
  EXPECT_EQ(drawPanel(panel({0, NAN, NAN, 7}, 0, 7), 10, 3), (Lines{"         7",  //
                                                                    "      7┤ ⠈",  //
                                                                    "      0┤⡀ "}));
}

TEST(DrawPanel, ScalesToTheValues) {
  const Lines lines = drawPanel(panel({-2, -1.5, -1, -1}), 20, 4);
  EXPECT_EQ(lines[0], "        reward    -1");
  EXPECT_EQ(lines[1].substr(0, 10), "     -1┤");
  EXPECT_EQ(lines[2].substr(0, 10), "       │");
  EXPECT_EQ(lines[3].substr(0, 10), "     -2┤");
}

TEST(DrawPanel, DrawsConstantValuesAndNone) {
  EXPECT_EQ(drawPanel(panel({3, 3}), 10, 3), (Lines{"         3", "      4┤  ", "      3┤⣀⣀"}));
  EXPECT_EQ(drawPanel(panel({}), 10, 3), (Lines{"        re", "      1┤  ", "      0┤  "}));
}

TEST(DrawPanel, KeepsValuesOutsideOfTheAxisAtItsEnds) {
  EXPECT_EQ(drawPanel(panel({9, 9, -9, -9}, 0, 7), 10, 3), (Lines{"        -9",  //
                                                                  "      7┤⠉⡆",  //
                                                                  "      0┤ ⣇"}));
}

TEST(ShortNumber, HasAtMostSixCharacters) {
  EXPECT_EQ(shortNumber(0), "0");
  EXPECT_EQ(shortNumber(100), "100");
  EXPECT_EQ(shortNumber(52489), "52489");
  EXPECT_EQ(shortNumber(0.3), "0.300");
  EXPECT_EQ(shortNumber(-1.8468), "-1.847");
  EXPECT_EQ(shortNumber(98.24), "98.2");
  EXPECT_EQ(shortNumber(-123.45), "-123.5");
  EXPECT_EQ(shortNumber(1234567), "1.23M");
  EXPECT_EQ(shortNumber(123456789), "123M");
  for (const double value : {-9.9996, 999.96, 99999.6, 9999999.7, -99999.4, 12345.6}) {
    EXPECT_LE(shortNumber(value).size(), 6U) << value;
  }
}

}  // namespace
}  // namespace crowd::text_plot_test
