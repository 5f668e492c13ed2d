#include "social_crowd/simulation/learned_robot.h"

#include "social_crowd/simulation/steering.h"

namespace crowd {

Twist LearnedRobot::command(const World& world, RobotId id, const Vector2& goal) {
  const Robot& robot = world.robots()[id];
  const Vector2 point = finds_ways_ ? way_.next(world, robot, goal) : goal;
  world.perceiveRobot(learner_->model().vision(), id, point, perception_workspace_, perceptions_);
  actions_.clear();
  learner_->decideGreedily(perceptions_, decision_workspace_, actions_);
  const RelativeAction& action = actions_.front().action;
  return steer(robot.start.drive, wrapAngle(action.rotation), action.speed_fraction * robot.start.limits.max_speed);
}

}  // namespace crowd
