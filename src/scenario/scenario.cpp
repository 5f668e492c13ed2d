#include "scenario/scenario.h"

#include <algorithm>
#include <cmath>

#include "social_crowd/errors.h"

namespace crowd {

Vector2 Region::draw(KeyedRandom& random, const FreeSpace* free_space) const {
  if (kind == Kind::FREE) return free_space->draw(random);
  if (kind == Kind::BOX) {
    const double x = random.uniform(first.x(), second.x());
    return {x, random.uniform(first.y(), second.y())};
  }
  if (kind == Kind::RING) {
    const double bearing = random.uniform(-PI, PI);
    // For a uniform density over the area, the square of the distance is uniform.
    const double squared = random.uniform(radius.low * radius.low, radius.high * radius.high);
    return first + (radius.isFixed() ? radius.low : std::sqrt(squared)) * unitVector(bearing);
  }
  return first;
}

Vector2 Between::draw(const AgentStart& start, KeyedRandom& random) const {
  const Vector2 way = start.goals.front() - start.position;
  const double along = share.draw(random);
  const Vector2 left = unitVector(bearingOf(way) + PI / 2.0);
  return start.position + along * way + aside.draw(random) * left;
}

bool ScenarioList::keepHeadings() const {
  const auto keeps = [](const AgentGroup& group) { return group.keeps_heading; };
  return std::any_of(scenarios_.begin(), scenarios_.end(), [&](const Scenario& scenario) {
    return std::any_of(scenario.agents.begin(), scenario.agents.end(), keeps);
  });
}

std::vector<std::string> ScenarioList::warnings() const {
  std::vector<std::string> all;
  for (const Scenario& scenario : scenarios_) {
    all.insert(all.end(), scenario.warnings.begin(), scenario.warnings.end());
  }
  return all;
}

Scene ScenarioList::scene(std::uint64_t run_seed, std::uint64_t episode, const StopRequest& stop) const {
  if (scenarios_.empty()) {
    throw InputError("there is no scenario to play");
  }
  return scenarios_[episode % scenarios_.size()].instantiate(run_seed, episode, stop);
}

}  // namespace crowd
