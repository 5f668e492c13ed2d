#include "population/gate.h"
#include "world/world_editor.h"

#include <algorithm>

namespace crowd {
namespace {

bool isOccupied(const Segment& wall, const World& world) {
  const auto stands_in_it = [&](const Agent& agent) {
    return agent.isPresent() && distanceTo(wall, agent.pose.position) < agent.radius;
  };
  const auto is_in_it = [&](const Robot& robot) { return isCutBy(robot.start.footprint, robot.pose, wall, 0.0); };
  return std::any_of(world.agents().begin(), world.agents().end(), stands_in_it) ||
         std::any_of(world.robots().begin(), world.robots().end(), is_in_it);
}

}  // namespace

void Gate::follow(double time) {
  const bool open = gate_->isOpen(time);
  if (open == scheduled_) return;
  scheduled_ = open;
  wants_open_ = open;
}

void Gate::setOpen(bool open, double time) {
  follow(time);
  wants_open_ = open;
}

void Gate::update(World& world) {
  follow(world.time());
  const auto& ids = world.walls().ids();
  if (wall_ && !std::binary_search(ids.begin(), ids.end(), *wall_)) wall_.reset();  // it was removed by another caller
  if (wants_open_ && wall_) {
    WorldEditor(world).removeWall(*wall_);
    wall_.reset();
  } else if (!wants_open_ && !wall_ && !isOccupied(gate_->wall, world)) {
    wall_ = WorldEditor(world).addWall(gate_->wall);
  }
}

}  // namespace crowd
