#include "social_crowd/simulation/trajectory.h"

#include "social_crowd/common/numbers.h"

namespace crowd {

void appendTrajectoryRows(std::uint64_t instance, const World& world, std::string& rows) {
  const std::string begin = std::to_string(instance) + "," + std::to_string(world.tick()) + ",";
  for (const Agent& agent : world.agents()) {
    const bool just_arrived = agent.hasArrived() && agent.arrival_tick == world.tick();
    if (!agent.isWalking() && !just_arrived) continue;
    rows += begin + std::to_string(agent.id) + "," + toText(agent.pose.position.x()) + "," +
            toText(agent.pose.position.y()) + "\n";
  }
}

TrajectoryFile::TrajectoryFile(const std::string& folder, const std::string& name)
    : file_((makeFolder(folder), folder + "/" + name + ".csv"), TRAJECTORY_HEADER) {}

}  // namespace crowd
