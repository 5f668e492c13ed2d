#include "simulation/robot_controller.h"

#include <algorithm>

#include "common/text/quotes.h"
#include "common/text/suggestions.h"
#include "robots/controllers/learned_robot.h"
#include "robots/controllers/orca_robot.h"
#include "robots/controllers/reactive_rule.h"
#include "robots/controllers/social_force_robot.h"
#include "robots/controllers/steering.h"

namespace crowd {
namespace {

/// Drives straight to the goal (steer()), and ignores everything in between; it slows down in the last metre.
class StraightController : public RobotController {
 public:
  Twist command(const RobotView& view) override {
    const Robot& robot = view.robot();
    const Vector2 way = Rotation(robot.pose.heading).intoFrame(view.goal - robot.pose.position);
    return steer(robot.start.drive, bearingOf(way), robot.start.limits.max_speed * std::min(1.0, way.norm()));
  }
};

/// Decides by the Q-table of the crowd.
class LearnedController : public RobotController {
 public:
  LearnedController(const Learner& learner, const Episode& episode)
      : robot_(learner, episode.number(), episode.scene().way_finding) {}

  Twist command(const RobotView& view) override { return robot_.command(view.world, view.id, view.goal); }

 private:
  LearnedRobot robot_;
};

/// Follows a method that plans with what it perceives and the floor plan.
template <typename Method>
class PlanningController : public RobotController {
 public:
  explicit PlanningController(const Episode& episode) : robot_(episode.number(), episode.scene().way_finding) {}

  Twist command(const RobotView& view) override { return robot_.command(view.world, view.id, view.goal); }

 private:
  Method robot_;
};

/// Sees what its laser scanner sees, and knows where its goal is.
class ReactiveController : public RobotController {
 public:
  Twist command(const RobotView& view) override {
    const Robot& robot = view.robot();
    const Vector2 goal = Rotation(robot.pose.heading).intoFrame(view.goal - robot.pose.position);
    return reactiveCommand(robot.start, goal, view.senses.ranges(view.world, view.id));
  }
};

}  // namespace

const std::vector<std::string>& robotControllerNames() {
  static const std::vector<std::string> NAMES = {"none", "straight", "reactive", "learned", "orca", "social_force"};
  return NAMES;
}

std::unique_ptr<RobotController> makeRobotController(const std::string& name, const Episode& episode,
                                                     const Learner& learner) {
  if (name == "none") return nullptr;
  if (name == "straight") return std::make_unique<StraightController>();
  if (name == "reactive") return std::make_unique<ReactiveController>();
  if (name == "learned") return std::make_unique<LearnedController>(learner, episode);
  if (name == "orca") return std::make_unique<PlanningController<OrcaRobot>>(episode);
  if (name == "social_force") return std::make_unique<PlanningController<SocialForceRobot>>(episode);
  throw InputError("robot controller: expected " + joinAlternatives(robotControllerNames()) + ", got " +
                   inQuotes(name));
}

RobotDrivers::RobotDrivers(const std::string& controller, const Episode& episode, const Learner& learner)
    : senses_(episode.scene()) {
  for (const Robot& robot : episode.world().robots()) {
    const bool is_commanded = robot.start.drive != Drive::EXTERNAL;
    controllers_.push_back(is_commanded ? makeRobotController(controller, episode, learner) : nullptr);
  }
}

void RobotDrivers::command(Episode& episode) {
  if (episode.world().tick() > 0) senses_.observe(episode.world());
  for (RobotId id = 0; id < controllers_.size(); ++id) {
    if (!controllers_[id]) continue;
    const Robot& robot = episode.world().robots()[id];
    const bool drives = robot.hasGoal() && !robot.hasArrived();
    episode.robots().command(
        id, drives ? controllers_[id]->command({episode.world(), id, robot.goal(), senses_}) : Twist());
  }
}

}  // namespace crowd
