#include "population/alarms.h"

#include <algorithm>
#include <utility>

#include "scenario/region_geometry.h"

namespace crowd {

Alarms::Alarms(const std::vector<AlarmDescription>& alarms) : all_(alarms.begin(), alarms.end()) {
  for (std::size_t i = 0; i < all_.size(); ++i) pending_.push_back(i);
  const auto is_earlier = [&](std::size_t first, std::size_t second) { return all_[first].time < all_[second].time; };
  std::stable_sort(pending_.begin(), pending_.end(), is_earlier);
}

std::vector<std::size_t> Alarms::takeDue(double now) {
  const auto waits = [&](std::size_t number) { return all_[number].time > now + TIME_ROUNDING; };
  const auto end = std::find_if(pending_.begin(), pending_.end(), waits);
  std::vector<std::size_t> due(pending_.begin(), end);
  pending_.erase(pending_.begin(), end);
  return due;
}

std::size_t Alarms::add(AlarmDescription alarm) {
  all_.push_back(std::move(alarm));
  return all_.size() - 1;
}

std::vector<AgentId> agentsOf(const AlarmDescription& alarm, const World& world) {
  std::vector<AgentId> ids;
  for (const Agent& agent : world.agents()) {
    if (!agent.isWalking() || (alarm.area && !contains(*alarm.area, agent.pose.position))) continue;
    ids.push_back(agent.id);
  }
  return ids;
}

bool endsSource(const AlarmDescription& alarm, const SourceDescription& source) {
  if (!alarm.route || alarm.keeps_sources) return false;
  if (!alarm.area) return true;
  const Region& place = source.agents.position;
  return place.kind != Region::Kind::FREE && contains(*alarm.area, middleOf(place));
}

}  // namespace crowd
