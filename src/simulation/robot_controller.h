#pragma once

#include <memory>
#include <string>
#include <vector>

#include "learning/learner.h"
#include "robots/robot_senses.h"
#include "simulation/episode.h"

namespace crowd {

/// @brief What a controller knows about its robot at a tick.
struct RobotView {
  const World& world;
  RobotId id;
  Vector2 goal;         ///< next point to drive to [m], `map`
  RobotSenses& senses;  ///< of all robots

  const Robot& robot() const { return world.robots()[id]; }
};

/// @brief Drives one robot in one episode.
class RobotController {
 public:
  RobotController() = default;
  RobotController(const RobotController&) = delete;
  RobotController& operator=(const RobotController&) = delete;
  virtual ~RobotController() = default;

  /// @brief The command of the coming tick. Called once a tick, while the robot is on its way to a goal.
  virtual Twist command(const RobotView& view) = 0;
};

/// @brief Names of the controllers, for messages and --help: "none" (the robot stands), "straight" (straight to the
/// goal; it ignores people), "reactive" (by its laser scan alone, see reactiveCommand()), "learned" (as the crowd, see
/// LearnedRobot), "orca" (OrcaRobot), "social_force" (SocialForceRobot).
const std::vector<std::string>& robotControllerNames();

/// @brief Makes a controller of a robot of an episode; null for "none". @param learner decides for "learned", and must
/// outlive the controller @throws InputError that lists the names
std::unique_ptr<RobotController> makeRobotController(const std::string& name, const Episode& episode,
                                                     const Learner& learner);

/// @brief Controllers of all robots of an episode that take commands.
class RobotDrivers {
 public:
  /// @param controller name of the controller of each robot, see makeRobotController()
  RobotDrivers(const std::string& controller, const Episode& episode, const Learner& learner);

  /// @brief Commands all robots for the coming tick; call it once before each tick. Robots that have arrived or have no
  /// goal are stopped.
  void command(Episode& episode);

 private:
  RobotSenses senses_;
  std::vector<std::unique_ptr<RobotController>> controllers_;  // by robot; null: it gets no commands
};

}  // namespace crowd
