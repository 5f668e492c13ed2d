#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/span.h"
#include "geometry/robot_sweep.h"
#include "geometry/solid_motion.h"
#include "scenario/robot.h"
#include "scenario/scene.h"
#include "world/agent.h"
#include "world/protective_stop.h"

namespace crowd {

/// @brief The motion of a person in a tick, if nothing is in the way.
struct PersonMotion {
  AgentId id = 0;
  double radius = 0.0;              ///< [m]
  Vector2 start = Vector2::Zero();  ///< [m], `map`
  Vector2 way = Vector2::Zero();    ///< [m]
  std::uint32_t disc = 0;           ///< index among the bodies of a solid world
};

/// @brief The robots of a world: what they are told to do, their motions, and their contacts with people. They are not
/// in the grid of bodies: there are few of them, and agents perceive them as discs that are larger than their
/// footprints, or not at all.
///
/// In each tick World calls beginMoves(), in a solid world addDiscs(), noteSolidContacts(), noteRecordedContacts() and
/// replaceMotions(), in a ghost world noteGhostContacts(), then endMoves().
class Robots {
 public:
  explicit Robots(const Scene& scene);

  const std::vector<Robot>& list() const { return robots_; }
  std::vector<Robot>::const_iterator begin() const { return robots_.begin(); }
  std::vector<Robot>::const_iterator end() const { return robots_.end(); }
  std::size_t size() const { return robots_.size(); }
  bool empty() const { return robots_.empty(); }
  const Robot& operator[](RobotId id) const { return robots_[id]; }
  /// @brief Number of times that a robot came, left or got other goals, or the same ones again.
  std::uint64_t changes() const { return changes_; }

  /// @brief Sets what a robot is to do from the next tick on, until the next call; it follows within its limits.
  /// People know the command only after that tick, so that it may be given before or after they perceive.
  /// @throws InputError if there is no such robot, it is EXTERNAL, or a number is not finite.
  void command(RobotId id, const Twist& wanted);
  /// @brief Sets where an EXTERNAL robot is at the end of the coming tick; it stays there until the next call. The
  /// place may be occupied. @param pose in `map` @param velocity [m/s], `map` @param jump it does not move
  /// there on a straight line: it is at the place from the start of the tick on, without a velocity. @throws InputError
  /// if there is no such EXTERNAL robot or a number is not finite.
  void place(RobotId id, const Pose& pose, const Vector2& velocity, bool jump);
  /// @brief Replaces the goals of a robot [m], `map`; none: it has no goal any more.
  /// @throws InputError if there is no such robot or a number is not finite.
  void setGoals(RobotId id, std::vector<Vector2> goals);
  /// @brief Lets a user send a robot to a goal [m], `map`. Its arrival ends no episode: the user may send it on.
  /// @throws InputError if there is no such robot or a number is not finite.
  void send(RobotId id, const Vector2& goal);
  /// @brief Adds a robot. Call WorldEditor::addRobot(), which checks it.
  RobotId add(const RobotStart& start);
  /// @brief Removes a robot; the ids of those after it become smaller by one.
  void remove(RobotId id);
  /// @brief Lets a robot stand at another place, see WorldEditor::teleportRobot().
  void teleport(RobotId id, const Pose& pose);

  /// @brief Whether the rim of a robot is within a distance of a place [m].
  bool isAnyWithin(double distance, const Vector2& place) const;
  /// @brief The name of a robot that overlaps a disc [m]; empty if none does. @param except a robot that is ignored
  std::string blockerAt(const Vector2& centre, double radius, std::optional<RobotId> except) const;
  /// @brief The robot of this name. @throws InputError if there is none
  RobotId idOf(const std::string& name) const;
  /// @brief The robot. @throws InputError if there is none
  const Robot& require(RobotId id) const;

  /// @brief Determines the motions of the coming tick.
  void beginMoves(const std::vector<Agent>& agents, const std::vector<Neighbour>& recorded = {});
  /// @brief Motions of robots that stand still, while an agent moves alone.
  void hold();
  /// @brief Appends the motions as solid bodies.
  void addDiscs(std::vector<SolidMotion::Disc>& discs) const;
  /// @brief Notes contacts with the agents. @param discs the intended motions of agents on their way, then others, then
  /// of the robots @param moved what has become of them
  void noteSolidContacts(const std::vector<Agent>& agents, const std::vector<SolidMotion::Disc>& discs,
                         const SolidMotion& moved);
  /// @brief Replaces the motions by those after impacts. @param sweeps of the robots
  void replaceMotions(const std::vector<RobotSweep>& sweeps) { sweeps_ = sweeps; }
  /// @brief Notes contacts with recorded people in a solid world. They pass over robots that have stopped.
  void noteRecordedContacts(const std::vector<PersonMotion>& recorded, const SolidMotion& moved);
  /// @brief Notes contacts with agents that have just moved for a time [s] in a ghost world.
  void noteGhostContacts(const Span<Agent>& agents, double time);
  /// @brief Notes contacts with people whom nothing stops and who stop nothing.
  void noteGhostContacts(const std::vector<PersonMotion>& people);
  /// @brief Puts the robots where they are at the end of the tick, and counts the goals that they have reached.
  void endMoves();

 private:
  /// Where an EXTERNAL robot is at the end of a tick.
  struct Place {
    Pose pose;
    Vector2 velocity = Vector2::Zero();  // `map` [m/s]
    bool jump = false;
  };

  Robot& find(RobotId id);
  void noteContact(RobotId id, const PersonMotion& person);
  void noteGhostContact(RobotId id, const PersonMotion& person);

  double tick_duration_;
  Contact contact_;
  std::vector<Robot> robots_;
  std::uint64_t changes_ = 0;
  // By robot:
  std::vector<Twist> commands_;                      // what it is to do next
  std::vector<std::optional<Place>> places_;         // where an EXTERNAL one is to be next
  std::vector<RobotSweep> sweeps_;                   // its intended motion in this tick
  std::vector<std::vector<RobotContact>> contacts_;  // those of the present tick so far
  ProtectiveStop protective_stop_;
};

}  // namespace crowd
