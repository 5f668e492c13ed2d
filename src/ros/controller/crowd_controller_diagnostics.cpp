// Samples for the diagnostics of the crowd controller. All functions run in the main loop.

#include "ros/controller/crowd_controller.h"

namespace crowd {

void CrowdController::addDiagnostics() {
  const auto add = [this](const char* name, auto report) {
    diagnostics_.add(name, [this, report](auto& status) { report(last_sample_, sample_, status); });
  };
  add("ticks", reportTicks);
  add("answers", reportAnswers);
  add("robots", reportCommands);
  takeSample();
}

void CrowdController::takeSample() {
  last_sample_ = std::move(sample_);
  sample_ = {};
  sample_.at = Clock::now();
  sample_.ticks = ticks_;
  sample_.decisions = decisions_;
  sample_.answers = answers_.totals();
  sample_.robots = episode_->world().robots().size();
  sample_.commands = robots_.commands().totals();
  sample_.paused = parameters_.paused;
  const double factor = presentFactor();
  sample_.tick_rate = factor / episode_->scene().tick_duration;
  sample_.status = status();
  if (last_sample_.at.isZero()) last_sample_ = sample_;
}

}  // namespace crowd
