#include "tools/terminal/training_plot.h"

#include <algorithm>
#include <limits>

#include "common/text/numbers.h"
#include "tools/terminal/text_plot.h"
#include "training/record.h"

namespace crowd {
namespace {

constexpr double OPEN = std::numeric_limits<double>::quiet_NaN();
constexpr int GAP = 2;             // blanks between two panels
constexpr int GOOD_COLUMNS = 36;   // of a panel
constexpr int LEAST_COLUMNS = 20;  // of a panel
constexpr int MOST_ROWS = 9;       // of a panel
constexpr int GOOD_ROWS = 4;       // of a panel
constexpr int LEAST_ROWS = 3;      // of a panel
constexpr int OTHER_ROWS = 5;      // below the panels: line about the axis, progress bar, what is printed at the end

/// How panels are arranged; no panels if there is no space.
struct Layout {
  int across = 0;   // panels beside each other
  int down = 0;     // panels below each other
  int columns = 0;  // of a panel
  int rows = 0;     // of a panel
};

Layout layoutFor(int panels, const TerminalSize& terminal) {
  const int rows = terminal.rows - OTHER_ROWS;
  const auto rows_with = [&](int across) { return rows / ((panels + across - 1) / across); };
  const int most = std::min(panels, (terminal.columns + GAP) / (LEAST_COLUMNS + GAP));
  if (most < 1 || rows < LEAST_ROWS) return {};
  int across = std::clamp((terminal.columns + GAP) / (GOOD_COLUMNS + GAP), 1, most);
  while (across < most && rows_with(across) < GOOD_ROWS) ++across;
  const int height = std::clamp(rows_with(across), LEAST_ROWS, MOST_ROWS);
  const int down = std::min((panels + across - 1) / across, rows / height);
  return {across, down, (terminal.columns + GAP) / across - GAP, height};
}

}  // namespace

TrainingPlot::TrainingPlot(std::uint64_t first_episode, std::string_view log)
    : first_episode_(first_episode),
      curves_{{"success [%]", EpisodeCurve(), 0.0, 100.0},
              {"contact [%]", EpisodeCurve(), 0.0, 100.0},
              {"mean reward", EpisodeCurve(), OPEN, OPEN},
              {"visited rows", EpisodeCurve(), 0.0, OPEN},
              {"epsilon", EpisodeCurve(), 0.0, OPEN}} {
  while (!log.empty()) {
    const std::size_t end = std::min(log.find('\n'), log.size());
    if (const std::optional<Values> values = valuesOf(log.substr(0, end))) add(*values);
    log.remove_prefix(std::min(end + 1, log.size()));
  }
  first_episode_ -= std::min(first_episode_, curves_.front().values.episodes());
}

/// The fields are found from the end of the row: names of scenarios may contain commas.
std::optional<TrainingPlot::Values> TrainingPlot::valuesOf(std::string_view log_row) {
  constexpr std::size_t NUMBERS = 7;  // success, contact, collision, reward, visited rows, epsilon, decisions
  std::array<double, NUMBERS> numbers{};
  for (std::size_t i = NUMBERS; i-- > 0;) {
    const std::size_t comma = log_row.rfind(',');
    if (comma == std::string_view::npos) return std::nullopt;
    const std::optional<double> number = toNumber(log_row.substr(comma + 1));
    if (!number) return std::nullopt;
    numbers.at(i) = *number;
    log_row = log_row.substr(0, comma);
  }
  return Values{100.0 * numbers[0], 100.0 * numbers[1], numbers[3], numbers[4], numbers[5]};
}

void TrainingPlot::add(const Values& values) {
  for (std::size_t i = 0; i < curves_.size(); ++i) curves_[i].values.add(values.at(i));
}

void TrainingPlot::add(const LearnedEpisode& learned) {
  add(Values{100.0 * successShare(learned), 100.0 * contactShare(learned), learned.reward,
             static_cast<double>(learned.visited_rows), learned.epsilon});
}

std::string TrainingPlot::axisLine(std::size_t points) const {
  const EpisodeCurve& curve = curves_.front().values;
  const std::uint64_t episodes = curve.episodes();
  if (episodes == 0) return std::string(PANEL_LABELS, ' ') + "no episode yet";
  const std::uint64_t each = std::max<std::uint64_t>(curve.binSize(), (episodes + points / 2) / points);
  return std::string(PANEL_LABELS, ' ') + "episodes " + std::to_string(first_episode_) + " to " +
         std::to_string(first_episode_ + episodes - 1) +
         (each > 1 ? ", about " + std::to_string(each) + " in a point" : "");
}

std::vector<std::string> TrainingPlot::lines(const TerminalSize& terminal) const {
  const Layout layout = layoutFor(static_cast<int>(curves_.size()), terminal);
  if (layout.across == 0) return {};
  const std::size_t points = 2 * static_cast<std::size_t>(layout.columns - PANEL_LABELS);
  std::vector<std::string> lines(static_cast<std::size_t>(layout.down * layout.rows));
  for (int i = 0; i < std::min<int>(layout.across * layout.down, static_cast<int>(curves_.size())); ++i) {
    const Curve& curve = curves_[static_cast<std::size_t>(i)];
    const std::vector<double> values = curve.values.means(points);
    const std::vector<std::string> panel =
        drawPanel({curve.title, values, values.back(), curve.low, curve.high}, layout.columns, layout.rows);
    for (int row = 0; row < layout.rows; ++row) {
      std::string& line = lines[static_cast<std::size_t>(i / layout.across * layout.rows + row)];
      line += (i % layout.across > 0 ? std::string(GAP, ' ') : "") + panel[static_cast<std::size_t>(row)];
    }
  }
  std::string axis = axisLine(points);
  axis.resize(std::min<std::size_t>(axis.size(), static_cast<std::size_t>(terminal.columns)));
  lines.push_back(std::move(axis));
  return lines;
}

}  // namespace crowd
