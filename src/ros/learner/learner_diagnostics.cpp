#include "ros/learner/learner_diagnostics.h"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include "common/text/numbers.h"
#include "ros/node/diagnostics_publisher.h"

namespace crowd {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

constexpr double QUIET_LIMIT = 1.0;  // [s]
constexpr double LACK_LIMIT = 5.0;   // [s]; a controller that waits for answers repeats perceptions ever more rarely

}  // namespace

void reportDecisions(const LearnerSample& before, const LearnerSample& now, DiagnosticStatusWrapper& report) {
  const std::string rate = toFixedText(rateOf(now.decisions - before.decisions, (now.at - before.at).toSec()), 1);
  const double silence = (now.at - now.last_perceptions).toSec();
  if (now.lacks_vision && silence <= LACK_LIMIT) {
    report.summary(DiagnosticStatus::WARN, "perceptions contain less than the model needs, they are not answered");
  } else if (now.last_perceptions.isZero()) {
    report.summary(DiagnosticStatus::OK, now.mode + ", no perceptions yet");
  } else if (silence > QUIET_LIMIT) {
    report.summary(DiagnosticStatus::OK, now.mode + ", no perceptions for " + toFixedText(silence, 0) + " s");
  } else {
    report.summary(DiagnosticStatus::OK, now.mode + ", " + rate + " decisions/s");
  }
  report.add("mode", now.mode);
  report.add("decisions per second", rate);
  report.add("decisions since the start", now.decisions);
  report.add("agents", now.agents);
  report.add("episode", now.episode);
}

void reportTable(const Learner& learner, AgentId agent, DiagnosticStatusWrapper& report) {
  const QTable& table = learner.tables().of(agent);
  const std::size_t cells = std::size_t{table.rows()} * table.actions();
  const Row visited = table.visitedRows();
  if (visited == 0 && learner.mode() == Mode::DEMO) {
    report.summary(DiagnosticStatus::WARN, "the table is empty");
  } else {
    report.summary(DiagnosticStatus::OK,
                   std::to_string(visited) + " of " + std::to_string(table.rows()) + " rows visited");
  }
  const LearningParameters& parameters = learner.parameters();
  report.add("rows", table.rows());
  report.add("visited rows", visited);
  report.add("actions", table.actions());
  report.add("visits", table.allVisits());
  report.add("bytes", cells * (sizeof(double) + sizeof(std::uint32_t)));  // values and visits
  report.add("tables", TABLE_USES.nameOf(learner.tables().use()));
  report.add("decisions learned from", learner.decisions());
  report.add("alpha", toText(parameters.alpha));
  report.add("gamma", toText(parameters.gamma));
  report.add("lambda", toText(parameters.lambda));
  report.add("epsilon", toText(parameters.epsilon));
}

}  // namespace crowd
