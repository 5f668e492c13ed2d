#include "tools/terminal/training_display.h"

#include <algorithm>

#include "common/text/numbers.h"
#include "tools/terminal/terminal.h"
#include "training/record.h"

namespace crowd {
namespace {

constexpr std::size_t RECENT = 200;  // episodes

}  // namespace

void RecentRates::add(const EpisodeResult& result) {
  if (result.agentCount() == 0) return;
  shares_.push_back({successShare(result), contactShare(result)});
  if (shares_.size() > RECENT) shares_.pop_front();
}

std::string RecentRates::text() const {
  Shares sum;
  for (const Shares& shares : shares_) {
    sum.success += shares.success;
    sum.contact += shares.contact;
  }
  const double percent = 100.0 / static_cast<double>(std::max<std::size_t>(shares_.size(), 1));
  return "success " + toFixedText(percent * sum.success, 1, 5) + " %  contact " +
         toFixedText(percent * sum.contact, 1, 5) + " %";
}

TrainingDisplay::TrainingDisplay(const Training& training, bool plots, std::string_view log)
    : training_(training),
      decisions_before_(training.decisions()),
      bar_("episode", training.config().training.episodes, training.episode()) {
  if (plots) plot_.emplace(training.episode(), log);
}

void TrainingDisplay::add(const LearnedEpisode& learned) {
  rates_.add(learned);
  if (plot_) plot_->add(learned);
}

void TrainingDisplay::show() {
  if (bar_.isDue(training_.episode()) && !training_.isDone()) bar_.show(training_.episode(), note(), above());
}

void TrainingDisplay::finish() { bar_.finish(training_.episode(), note(), above()); }

std::string TrainingDisplay::note() const {
  const auto decisions = static_cast<double>(training_.decisions() - decisions_before_);
  return rates_.text() + "  " + formatCount(decisions / bar_.seconds()) + " decisions/s";
}

std::vector<std::string> TrainingDisplay::above() const {
  return plot_ ? plot_->lines(terminalSize()) : std::vector<std::string>();
}

}  // namespace crowd
