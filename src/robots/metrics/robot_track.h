#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robots/metrics/progress.h"
#include "robots/metrics/robot_sample.h"
#include "robots/metrics/shortest_way.h"
#include "robots/metrics/statistic.h"

namespace crowd {

/// @brief Everything that is measured of one robot in an episode so far.
class RobotTrack {
 public:
  RobotTrack(const RobotMetricOptions& options, double tick_duration, const Robot& robot, const RobotSample& start);

  /// @brief Begins the goals of the robot, which drives there from where it is. @param way finds the ways there; it is
  /// asked for results only
  void setGoals(const Robot& robot, ShortestWay way);
  /// @brief Adds a tick. The goal that the robot drove to in it was nextGoal().
  void add(const ObservedRobot& observed, const RobotSample& sample);
  /// @brief Notes where the robot is at the end of a tick that does not count: it has arrived, and may get another
  /// goal.
  void follow(const RobotSample& sample);

  const std::string& name() const { return name_; }
  const std::vector<Vector2>& goals() const { return goals_; }
  /// @brief Robot::goals_set when it got these.
  std::uint64_t goalsSet() const { return goals_set_; }
  /// @brief Number of the goal to which it drives.
  std::size_t nextGoal() const { return next_goal_; }
  bool hasArrived() const { return success_; }
  /// @brief Of the last tick; at first that of the start.
  const RobotSample& last() const { return last_; }
  /// @brief Mean number of people over the ticks; NaN without ticks.
  double meanPeople() const;
  /// @brief Everything but the density of people, for which it does not know the floor.
  RobotResult result() const;

 private:
  /// A way that the robot drives without jumps.
  struct Stretch {
    Pose begin;
    std::vector<Vector2> stops;  // [m]
  };
  /// The way to one goal.
  struct Leg {
    Pose begin;                      // after the last jump
    std::vector<Stretch> stretches;  // up to the jumps
    double path_length = 0.0;        // [m]
    std::uint64_t ticks = 0;
    bool is_reached = false;
  };
  /// Times that something was there which was not there in the tick before.
  struct Beginnings {
    std::uint64_t count = 0;
    bool is_there = false;
    void add(bool now) {
      count += now && !is_there ? 1 : 0;
      is_there = now;
    }
  };
  /// Ticks in which a distance was below those of Hall's spaces.
  struct Spaces {
    std::uint64_t intimate = 0;
    std::uint64_t personal = 0;  // those of the smaller spaces included
    std::uint64_t social = 0;
    void add(double distance);
  };

  static void addStretch(Stretch stretch, std::vector<Stretch>& stretches);
  void noteStates(const RobotSample& sample);
  void noteJump(const RobotSample& sample);
  void addMotion(const RobotSample& sample);
  void addPeople(const RobotSample& sample);
  void addContacts(const std::vector<RobotContact>& contacts, const RobotSample& sample);
  void addProgress(const Robot& robot, const RobotSample& sample, double step);
  void writeMotion(RobotResult& result) const;
  void writePeople(RobotResult& result) const;
  void writeContacts(RobotResult& result) const;
  void writeWay(RobotResult& result) const;
  RobotGoalResult resultOf(std::size_t goal) const;
  ShortestWay::Way shortest(const std::vector<Stretch>& stretches, const Stretch& last) const;
  double seconds(std::uint64_t ticks) const { return static_cast<double>(ticks) * tick_duration_; }
  double shareOf(std::uint64_t ticks) const;

  RobotMetricOptions options_;
  double tick_duration_ = 0.0;
  std::string name_;
  double max_speed_ = 0.0;  // that it may have [m/s]
  double goal_tolerance_ = 0.0;
  RobotSample last_;
  bool success_ = false;
  Vector2 arrival_ = Vector2::Zero();  // where it last arrived [m]
  std::uint64_t ticks_ = 0;

  std::vector<Vector2> goals_;
  std::uint64_t goals_set_ = 0;
  std::vector<Stretch> stretches_;  // up to jumps, and to arrivals before it got these goals
  Stretch way_on_;  // from there on; its stops: where it got its goals, unless that is the begin, and the goals
  std::size_t next_goal_ = 0;
  std::vector<Leg> legs_;  // by goal, up to the present one
  mutable ShortestWay way_;
  Progress progress_;
  double path_length_ = 0.0;
  double sum_of_angles_ = 0.0;  // to the goal, times the path [rad m]
  double final_distance_ = RobotResult::NONE;
  Statistic last_goal_distance_;

  Statistic speed_;
  Statistic acceleration_;
  Statistic jerk_;
  double rotation_ = 0.0;  // sum of the absolute ones [rad]
  std::uint64_t still_ticks_ = 0;
  std::uint64_t stalled_ticks_ = 0;

  std::uint64_t by_robot_ = 0;  // contacts with people by cause
  std::uint64_t by_person_ = 0;
  std::uint64_t mutual_ = 0;
  std::uint64_t contact_ticks_ = 0;
  Beginnings wall_;
  Beginnings obstacle_;
  Beginnings other_robot_;
  Statistic obstacle_clearance_;

  Statistic nearest_person_;
  Statistic farthest_person_;
  Statistic nearest_clearance_;
  Statistic people_clearance_;
  Statistic time_to_collision_;
  Statistic nearest_speed_;
  double conflicts_by_robot_ = 0.0;  // resolved [m]
  double conflicts_by_people_ = 0.0;
  double people_speed_ = 0.0;  // sum over people and ticks [m/s]
  std::uint64_t people_ = 0;   // the same of their numbers
  std::uint64_t near_ticks_ = 0;
  Spaces spaces_;
  Spaces group_spaces_;
  Beginnings in_group_;
  double force_on_robot_ = 0.0;  // sums over the ticks [m/s^2]
  double force_on_people_ = 0.0;
  double social_work_ = 0.0;
  double obstacle_force_ = 0.0;
  double obstacle_force_on_people_ = 0.0;
};

}  // namespace crowd
