#include "robots/controllers/learned_robot.h"

#include <cmath>

#include "robots/controllers/steering.h"

namespace crowd {
namespace {

constexpr double ALIGNED = toRadians(2.0);  // [rad]

}  // namespace

Twist LearnedRobot::command(const World& world, RobotId id, const Vector2& goal) {
  const Robot& robot = world.robots()[id];
  actions_.clear();
  learner_->decideGreedily(perceiver_.perceive(world, learner_->model().vision(), id, goal), decision_workspace_,
                           actions_);
  const RelativeAction& action = actions_.front().action;
  const double bearing = wrapAngle(action.rotation);
  turns_ = robot.start.drive == Drive::DIFFERENTIAL && (turns_ || robot.blocked) && std::abs(bearing) > ALIGNED;
  const double speed = turns_ ? 0.0 : action.speed_fraction * robot.start.limits.max_speed;
  return steer(robot.start.drive, bearing, speed);
}

}  // namespace crowd
