#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/terminal/progress_bar.h"
#include "tools/terminal/training_plot.h"
#include "training/training.h"

namespace crowd {

/// @brief Means of success and contact over the last episodes with agents [%].
class RecentRates {
 public:
  void add(const EpisodeResult& result);
  /// @brief Returns "success  98.5 %  contact   0.0 %".
  std::string text() const;

 private:
  struct Shares {
    double success = 0.0;
    double contact = 0.0;
  };
  std::deque<Shares> shares_;
};

/// @brief Shows on standard error how a training gets on: a progress bar, and on request curves above it.
class TrainingDisplay {
 public:
  /// @param training must outlive the display; it may have gone on from a checkpoint
  /// @param plots whether it draws curves
  /// @param log the log of the training so far, whose episodes belong to the curves; empty: none
  TrainingDisplay(const Training& training, bool plots, std::string_view log);

  /// @brief Adds the next episode.
  void add(const LearnedEpisode& learned);
  /// @brief Draws, at most ten times per second.
  void show();
  /// @brief Draws a last time.
  void finish();
  /// @brief Returns the time since the construction [s].
  double seconds() const { return bar_.seconds(); }

 private:
  std::string note() const;
  std::vector<std::string> above() const;

  const Training& training_;
  std::uint64_t decisions_before_;  // of an earlier run
  ProgressBar bar_;
  RecentRates rates_;
  std::optional<TrainingPlot> plot_;
};

}  // namespace crowd
