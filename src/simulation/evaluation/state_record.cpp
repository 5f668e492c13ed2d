#include "simulation/evaluation/state_record.h"

#include <cmath>

#include "common/text/numbers.h"
#include "learning/states/obstacle_classes.h"

namespace crowd {
namespace {

/// An angle in degrees, rounded to remove the error of the conversion.
std::string roundedDegrees(double angle) { return toText(std::round(toDegrees(angle) * 1e9) / 1e9); }

std::string textOf(const std::vector<OccupiedSector>& occupied) {
  std::string text;
  for (const OccupiedSector& sector : occupied) {
    text += (text.empty() ? "" : " ") + roundedDegrees(sector.from) + ":" + roundedDegrees(sector.to) + ":" +
            std::to_string(sector.distance_class);
  }
  return text;
}

}  // namespace

void appendStateRows(std::uint64_t instance, const Perceptions& perceptions, const Learner& learner,
                     std::string& rows) {
  const auto* const picture = dynamic_cast<const SectorPicture*>(learner.model().state_set.get());
  DecisionWorkspace workspace;
  std::vector<AgentAction> answers;
  learner.decideGreedily(perceptions, workspace, answers);
  auto choice = workspace.choices.begin();
  for (std::size_t i = 0; choice != workspace.choices.end(); ++i) {
    const AgentPerception& self = perceptions.agents[i];
    if (self.arrived) continue;
    rows += std::to_string(instance) + "," + std::to_string(perceptions.tick) + "," + std::to_string(self.agent);
    for (const double value : {self.pose.position.x(), self.pose.position.y(), toDegrees(self.pose.heading)}) {
      rows += "," + toText(value);
    }
    rows += "," + std::to_string(choice->row) + "," + std::to_string(choice->action) + ",";
    if (picture != nullptr) rows += textOf(picture->occupiedSectors(Perception(perceptions, i)));
    rows += "\n";
    ++choice;
  }
}

}  // namespace crowd
