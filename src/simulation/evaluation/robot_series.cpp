#include "simulation/evaluation/robot_series.h"

#include "common/text/numbers.h"

namespace crowd {

std::string robotSeriesHeader() {
  std::string header = "instance,tick,time,robot";
  RobotSample::visitFields([&](const std::string& name, const auto& /*value*/) { header += "," + name; },
                           RobotSample());
  return header + "\n";
}

void appendRobotSeries(std::uint64_t instance, std::uint64_t tick, double time, const RobotMonitor& monitor,
                       std::string& rows) {
  const std::string begin = std::to_string(instance) + "," + std::to_string(tick) + "," + toText(time) + ",";
  for (RobotId id = 0; id < monitor.size(); ++id) {
    const RobotSample* const sample = monitor.sampleOf(id);
    if (sample == nullptr) continue;
    rows += begin + monitor.nameOf(id);
    RobotSample::visitFields([&](const char* /*name*/, const auto& value) { rows += "," + toField(value); }, *sample);
    rows += "\n";
  }
}

}  // namespace crowd
