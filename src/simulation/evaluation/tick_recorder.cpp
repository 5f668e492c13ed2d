#include "simulation/evaluation/tick_recorder.h"

#include "simulation/evaluation/robot_series.h"
#include "simulation/evaluation/trajectory.h"

namespace crowd {

void TickRecorder::record(std::uint64_t instance, const Episode& episode) {
  const World& world = episode.world();
  if (wanted_.trajectory) appendTrajectoryRows(instance, world, records_.trajectory);
  if (wanted_.robot_log) log_.append(instance, episode, records_.robot_log);
  if (!wanted_.robot_series) return;
  appendRobotSeries(instance, world.tick(), world.time(), episode.robotMonitor(), records_.robot_series);
}

}  // namespace crowd
