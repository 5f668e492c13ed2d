#include "simulation/evaluation/trajectory.h"

#include "common/files/files.h"
#include "common/text/numbers.h"

namespace crowd {

void appendTrajectoryRows(std::uint64_t instance, const World& world, std::string& rows) {
  for (const Agent& agent : world.agents()) {
    if (hasTrajectoryRow(agent, world))
      appendTrajectoryRow(instance, world.tick(), agent.id, agent.pose.position, rows);
  }
}

bool hasTrajectoryRow(const Agent& agent, const World& world) {
  return agent.isPresent() || (agent.hasArrived() && agent.arrival_tick == world.tick());
}

void appendTrajectoryRow(std::uint64_t instance, std::uint64_t tick, AgentId agent, const Vector2& position,
                         std::string& rows) {
  rows += std::to_string(instance) + "," + std::to_string(tick) + "," + std::to_string(agent) + "," +
          toText(position.x()) + "," + toText(position.y()) + "\n";
}

TrajectoryFile::TrajectoryFile(const std::string& folder, const std::string& name)
    : file_((makeFolder(folder), folder + "/" + name + ".csv"), TRAJECTORY_HEADER) {}

}  // namespace crowd
