// Samples for the diagnostics of the learner. All functions run in the main loop.

#include "ros/learner/learner_node.h"

namespace crowd {

void LearnerNode::addDiagnostics() {
  diagnostics_.add("decisions", [this](auto& report) { reportDecisions(last_sample_, sample_, report); });
  diagnostics_.add("table", [this](auto& report) { reportTable(learner_, firstAgent(), report); });
  takeSample();
}

void LearnerNode::takeSample() {
  last_sample_ = sample_;
  sample_.at = ros::WallTime::now();
  sample_.last_perceptions = last_perceptions_;
  sample_.decisions = answered_;
  sample_.lacks_vision = lacksVision();
  sample_.mode = MODES.nameOf(learner_.mode());
  sample_.episode = episode_;
  sample_.agents = learner_.servedAgents().size();
  if (last_sample_.at.isZero()) last_sample_ = sample_;
}

}  // namespace crowd
