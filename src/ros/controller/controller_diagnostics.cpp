#include "ros/controller/controller_diagnostics.h"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <numeric>

#include "common/text/numbers.h"
#include "ros/controller/controller_parameters.h"
#include "ros/messages/agent_list.h"
#include "ros/node/diagnostics_publisher.h"

namespace crowd {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

double secondsBetween(const ControllerSample& before, const ControllerSample& now) {
  return (now.at - before.at).toSec();
}

/// Increase of a count that may begin again at 0.
std::uint64_t increase(std::uint64_t before, std::uint64_t now) { return now >= before ? now - before : now; }

std::uint64_t refusedOf(const CommandCounts& counts) {
  return std::accumulate(counts.refused.begin(), counts.refused.end(), std::uint64_t{0});
}

std::string rateText(double rate) { return toFixedText(rate, 1); }

/// Whether the ticks of the period can be compared with the wanted rate: it was the same all the time.
bool isComparable(const ControllerSample& before, const ControllerSample& now) {
  return !before.paused && before.tick_rate == now.tick_rate;
}

void judgePace(const ControllerSample& before, const ControllerSample& now, DiagnosticStatusWrapper& report) {
  const double seconds = secondsBetween(before, now);
  const std::uint64_t ticks = now.ticks - before.ticks;
  const std::string rate = rateText(rateOf(ticks, seconds));
  if (now.paused) return report.summary(DiagnosticStatus::OK, "paused");
  if (!isComparable(before, now)) return report.summary(DiagnosticStatus::OK, "walking");
  if (now.tick_rate <= 0.0) {
    if (ticks == 0) return report.summary(DiagnosticStatus::WARN, "no tick since the last report");
    return report.summary(DiagnosticStatus::OK, "as fast as possible: " + rate + " ticks/s");
  }
  // The last tick of the period may be in progress.
  const bool lags = static_cast<double>(ticks + 1) < MIN_RATE_SHARE * now.tick_rate * seconds;
  const std::string pace = rate + " of " + rateText(now.tick_rate) + " ticks/s";
  if (lags) return report.summary(DiagnosticStatus::WARN, "lags behind: " + pace);
  report.summary(DiagnosticStatus::OK, pace);
}

}  // namespace

void reportTicks(const ControllerSample& before, const ControllerSample& now, DiagnosticStatusWrapper& report) {
  judgePace(before, now, report);
  const social_crowd::ControllerStatus& status = now.status;
  report.add("ticks per second", rateText(rateOf(now.ticks - before.ticks, secondsBetween(before, now))));
  report.add("wanted ticks per second", now.tick_rate > 0.0 ? rateText(now.tick_rate) : "as fast as possible");
  report.add("real_time_factor", realTimeFactorText(status.real_time_factor));
  report.add("paused", now.paused ? "true" : "false");
  report.add("scenario", status.scenario);
  report.add("episode", status.episode);
  report.add("tick", status.tick);
  report.add("agents", status.agents);
  report.add("agents on their way", status.walking);
  report.add("agents arrived", status.arrived);
}

void reportAnswers(const ControllerSample& before, const ControllerSample& now, DiagnosticStatusWrapper& report) {
  const std::uint64_t decisions = now.decisions - before.decisions;
  const std::uint64_t missed = now.answers.missed - before.answers.missed;
  const std::uint64_t dropped = now.answers.dropped - before.answers.dropped;
  const std::uint64_t late = now.answers.late - before.answers.late;
  const std::vector<AgentId> unanswered(now.status.unanswered.begin(), now.status.unanswered.end());
  if (!unanswered.empty()) {
    report.summary(DiagnosticStatus::ERROR, "no answer for " + namedAgents(unanswered) + " for more than a second");
  } else if (missed + dropped > 0) {
    report.summary(DiagnosticStatus::WARN, std::to_string(missed) + " answers missed, " + std::to_string(dropped) +
                                               " dropped, of these " + std::to_string(late) + " late");
  } else {
    report.summary(DiagnosticStatus::OK, now.paused      ? "paused"
                                         : decisions > 0 ? "all answers in time"
                                                         : "no decisions");
  }
  report.add("decisions per second", rateText(rateOf(decisions, secondsBetween(before, now))));
  report.add("missed answers", missed);
  report.add("dropped answers", dropped);
  report.add("late answers", late);
  report.add("missed answers since the start", now.answers.missed);
  report.add("dropped answers since the start", now.answers.dropped);
  report.add("late answers since the start", now.answers.late);
  report.add("agents without an answer", unanswered.size());
}

void reportCommands(const ControllerSample& before, const ControllerSample& now, DiagnosticStatusWrapper& report) {
  const std::uint64_t missed = increase(before.commands.missed, now.commands.missed);
  const std::uint64_t late = increase(before.commands.late, now.commands.late);
  const std::uint64_t refused = increase(refusedOf(before.commands), refusedOf(now.commands));
  if (now.robots == 0) {
    report.summary(DiagnosticStatus::OK, "no robots");
  } else if (missed + late + refused > 0) {
    report.summary(DiagnosticStatus::WARN, std::to_string(missed) + " commands missed, " + std::to_string(late) +
                                               " late, " + std::to_string(refused) + " refused");
  } else {
    report.summary(DiagnosticStatus::OK, "all commands in time");
  }
  report.add("robots", now.robots);
  report.add("commands taken", increase(before.commands.taken, now.commands.taken));
  report.add("missed commands", missed);
  report.add("late commands", late);
  report.add("refused commands", refused);
}

}  // namespace crowd
