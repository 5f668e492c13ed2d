#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/terminal/episode_curve.h"
#include "tools/terminal/terminal.h"
#include "training/training_state.h"

namespace crowd {

/// @brief The live plot of a training: success, contact, reward, visited rows and epsilon over its episodes, as lines
/// of text. Does no input or output.
class TrainingPlot {
 public:
  /// @param first_episode number of the first episode that is added
  /// @param log rows of a log (record.h) with the episodes before; its header and damaged rows are left out
  explicit TrainingPlot(std::uint64_t first_episode = 0, std::string_view log = {});

  /// @brief Adds the next episode.
  void add(const LearnedEpisode& learned);

  /// @brief Returns the panels and a line about their horizontal axis, at most four lines less than the terminal has:
  /// the others are for the progress bar and for what is printed after it. Panels for which there is no space are left
  /// out, the last ones first.
  std::vector<std::string> lines(const TerminalSize& terminal) const;

 private:
  struct Curve {
    std::string title;
    EpisodeCurve values;
    double low;  // ends of its axis; NaN: those of the values
    double high;
  };
  /// Values of an episode in the order of the curves; NaN: unknown.
  using Values = std::array<double, 5>;
  static std::optional<Values> valuesOf(std::string_view log_row);
  void add(const Values& values);
  std::string axisLine(std::size_t points) const;

  std::uint64_t first_episode_;
  std::vector<Curve> curves_;
};

}  // namespace crowd
