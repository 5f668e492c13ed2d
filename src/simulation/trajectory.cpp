#include "social_crowd/simulation/trajectory.h"

#include <cerrno>
#include <cstring>

#include "social_crowd/common/errors.h"
#include "social_crowd/common/files.h"
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
    : path_(folder + "/" + name + ".csv") {
  makeFolder(folder);
  stream_.open(path_, std::ios::binary | std::ios::trunc);
  append(TRAJECTORY_HEADER);
}

void TrajectoryFile::append(const std::string& rows) {
  stream_ << rows << std::flush;
  if (!stream_) throw FileError(path_ + ": cannot be written: " + std::strerror(errno));
}

}  // namespace crowd
