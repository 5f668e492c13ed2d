#include "tools/terminal/training_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "training/record.h"

namespace crowd::training_plot_test {
namespace {

using Lines = std::vector<std::string>;

/// Number of characters of a text in UTF-8.
std::size_t lengthOf(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

/// An episode of two agents of which one arrives and one is in contact.
LearnedEpisode episode(double reward = -1.0) {
  LearnedEpisode learned;
  learned.agents.add(0).arrived = true;
  learned.agents.add(1).touched = true;
  learned.reward = reward;
  learned.visited_rows = 130;
  learned.epsilon = 0.25;
  return learned;
}

/// The titles of the panels, in their order.
std::string titlesIn(const Lines& lines) {
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const char* const title : {"success [%]", "contact [%]", "mean reward", "visited rows", "epsilon"}) {
    const std::size_t place = all.find(title);
    if (place != std::string::npos) found.emplace_back(place, title);
  }
  std::sort(found.begin(), found.end());
  std::string titles;
  for (const auto& [place, title] : found) titles += title + ", ";
  return titles;
}

TEST(TrainingPlot, ShowsTheLastValues) {
  TrainingPlot plot(20);
  for (int i = 0; i < 5; ++i) plot.add(episode());
  const Lines lines = plot.lines({200, 12});
  ASSERT_EQ(lines.size(), 8U);
  EXPECT_EQ(titlesIn(lines), "success [%], contact [%], mean reward, visited rows, epsilon, ");
  for (const char* const value : {" 50  ", " -1  ", " 130  ", " 0.250"}) {
    EXPECT_NE(lines[0].find(value), std::string::npos) << value << "\n" << lines[0];
  }
  EXPECT_EQ(lines.back(), "        episodes 20 to 24");
}

TEST(TrainingPlot, FitsEveryTerminal) {
  TrainingPlot plot;
  for (int i = 0; i < 1000; ++i) plot.add(episode(i));
  for (int columns = 1; columns < 260; ++columns) {
    for (const int rows : {1, 5, 7, 8, 9, 12, 24, 60}) {
      const Lines lines = plot.lines({columns, rows});
      EXPECT_LE(lines.size() + 4, static_cast<std::size_t>(std::max(4, rows))) << columns << " x " << rows;
      for (const std::string& line : lines) EXPECT_LE(lengthOf(line), static_cast<std::size_t>(columns));
      EXPECT_EQ(lines.empty(), columns < 20 || rows < 8) << columns << " x " << rows;
    }
  }
}

TEST(TrainingPlot, ArrangesItsPanels) {
  TrainingPlot plot;
  plot.add(episode());
  const auto first_line = [&](int columns, int rows) { return titlesIn({plot.lines({columns, rows}).front()}); };
  EXPECT_EQ(first_line(80, 24), "success [%], contact [%], ");
  EXPECT_EQ(first_line(120, 24), "success [%], contact [%], mean reward, ");
  EXPECT_EQ(first_line(80, 12), "success [%], contact [%], mean reward, ");  // a low terminal: narrower panels
  EXPECT_EQ(titlesIn(plot.lines({40, 14})), "success [%], contact [%], mean reward, ");  // no space for the others
}

TEST(TrainingPlot, ExplainsItsPoints) {
  TrainingPlot plot;
  EXPECT_EQ(plot.lines({80, 24}).back(), "        no episode yet");
  for (int i = 0; i < 620; ++i) plot.add(episode());
  EXPECT_EQ(plot.lines({80, 24}).back(), "        episodes 0 to 619, about 10 in a point");  // 31 characters, 62 points
}

TEST(TrainingPlot, GoesOnFromALog) {
  TrainingPlot whole;
  std::string log = LOG_HEADER;
  LearnedEpisode named = episode();
  named.scenario = "a, \"b\"";
  for (std::uint64_t i = 0; i < 7; ++i) {
    named.reward = i == 3 ? NAN : static_cast<double>(i);
    named.epsilon = 0.5 / static_cast<double>(i + 1);
    whole.add(named);
    appendLogRow(i, named, log);
  }
  const TrainingPlot rest(7, log);
  EXPECT_EQ(rest.lines({200, 24}), whole.lines({200, 24}));
  EXPECT_EQ(TrainingPlot(9, log + "7,cut,1,0.").lines({80, 24}).back(), "        episodes 2 to 8");
}

TEST(TrainingPlot, ShowsWhatTheLogHasIfNobodyIsExpectedToArrive) {
  LearnedEpisode endless = episode();
  for (AgentId agent = 0; agent < endless.agents.size(); ++agent) {
    endless.agents.add(agent).endless = true;
    endless.agents.add(agent).arrived = false;
  }
  TrainingPlot whole;
  whole.add(endless);
  std::string log = LOG_HEADER;
  appendLogRow(0, endless, log);
  EXPECT_EQ(whole.lines({200, 24}), TrainingPlot(1, log).lines({200, 24}));
  EXPECT_NE(whole.lines({200, 24})[0].find(" 100  "), std::string::npos);
}

TEST(TrainingPlot, SurvivesEpisodesWithoutAgents) {
  TrainingPlot plot;
  LearnedEpisode empty;
  empty.reward = NAN;
  plot.add(empty);
  EXPECT_EQ(titlesIn(plot.lines({200, 24})), "success [%], contact [%], mean reward, visited rows, epsilon, ");
}

}  // namespace
}  // namespace crowd::training_plot_test
