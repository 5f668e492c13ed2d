#include "robots/controllers/robot_way.h"

#include "navigation/walking_floor.h"
#include "social_crowd/errors.h"

namespace crowd {

Vector2 RobotWay::next(const World& world, const Robot& robot, const Vector2& goal) {
  const Vector2& position = robot.pose.position;
  const bool fits = contains(bounds_, position) && contains(bounds_, goal);
  if (layout_changes_ != world.layoutChanges() || !fits) adoptLayout(world, robot, goal);
  if (data_ == nullptr) return goal;
  if (!follower_ || follower_->goal() != goal) {
    follower_.emplace(goal);
    query_.emplace(data_->comfortable);
    is_tight_ = false;
  }
  Vector2 point = follower_->next(position, *query_);
  if (follower_->state() != PathFollower::State::ON_THE_WAY && !is_tight_) {
    query_.emplace(data_->tight);
    is_tight_ = true;
    follower_->recheck();
    point = follower_->next(position, *query_);
  }
  return follower_->state() == PathFollower::State::UNREACHABLE ? goal : point;
}

void RobotWay::adoptLayout(const World& world, const Robot& robot, const Vector2& goal) {
  layout_changes_ = world.layoutChanges();
  follower_.reset();
  query_.reset();
  data_.reset();
  const double radius = robot.start.footprint.reach();
  FloorPlan floor = walkingFloor(world, radius);
  includePoint(robot.pose.position, *floor.bounds);
  includePoint(goal, *floor.bounds);
  bounds_ = *floor.bounds;
  if (!hasBarriers(floor)) return;
  try {
    data_ = navigationData(floor, radius, world.stopRequest());
  } catch (const InputError&) {  // the floor is too large: it drives straight, as agents walk then
  }
}

}  // namespace crowd
