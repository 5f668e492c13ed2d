#include "simulation/evaluation/people_delay.h"

#include <algorithm>

namespace crowd {
namespace {

bool isComparable(const AgentResult& one, const AgentResult& other) {
  return one.arrived && other.arrived && one.appeared == other.appeared && one.start_x == other.start_x &&
         one.start_y == other.start_y;
}

}  // namespace

void measurePeopleDelay(const EpisodeResult& without, double tick_duration, EpisodeResult& with) {
  std::uint64_t people = 0;
  double delay = 0.0;
  double detour = 0.0;
  for (std::size_t i = 0; i < std::min(with.agents.size(), without.agents.size()); ++i) {
    const AgentResult& agent = with.agents[i];
    const AgentResult& alone = without.agents[i];
    if (!isComparable(agent, alone)) continue;
    ++people;
    delay += tick_duration * (static_cast<double>(agent.ticks) - static_cast<double>(alone.ticks));
    detour += agent.path_length - alone.path_length;
  }
  for (RobotResult& robot : with.robots) {
    robot.people_compared = people;
    if (people == 0) continue;
    robot.people_delay = delay / static_cast<double>(people);
    robot.people_detour = detour / static_cast<double>(people);
  }
}

}  // namespace crowd
