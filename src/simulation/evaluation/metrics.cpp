#include "simulation/evaluation/metrics.h"

#include <algorithm>

namespace crowd {

void Metrics::add(const EpisodeResult& result) {
  const EpisodeResult::Counts counts = result.count();
  ++episodes_;
  clean_ += counts.isClean() ? 1 : 0;
  agents_ += counts.agents;
  expected_ += counts.expected;
  touched_ += counts.touched;
  collided_ += counts.collided;
  blocked_moves_ += counts.blocked_moves;
  for (const AgentResult& agent : result.agents) {
    max_speed_ratio_ = std::max(max_speed_ratio_, agent.max_speed_ratio);
    if (!agent.arrived) continue;
    ++arrived_;
    path_ratio_ += agent.path_ratio;
    time_ratio_ += agent.time_ratio;
    turn_per_metre_ += agent.turn_per_metre;
  }
}

}  // namespace crowd
