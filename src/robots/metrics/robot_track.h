#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robots/metrics/contact_measures.h"
#include "robots/metrics/measured_time.h"
#include "robots/metrics/motion_measures.h"
#include "robots/metrics/people_measures.h"
#include "robots/metrics/progress.h"
#include "robots/metrics/robot_sample.h"
#include "robots/metrics/shortest_way.h"
#include "robots/metrics/statistic.h"

namespace crowd {

/// @brief Everything that is measured of one robot in an episode so far: its way to its goals, and what MotionMeasures,
/// ContactMeasures and PeopleMeasures add up.
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
  double meanPeople() const { return time_.mean(static_cast<double>(people_.people())); }
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

  static void addStretch(Stretch stretch, std::vector<Stretch>& stretches);
  void noteStates(const RobotSample& sample);
  void noteJump(const RobotSample& sample);
  void addProgress(const Robot& robot, const RobotSample& sample, double step);
  void writeWay(RobotResult& result) const;
  RobotGoalResult resultOf(std::size_t goal) const;
  ShortestWay::Way shortest(const std::vector<Stretch>& stretches, const Stretch& last) const;

  double stalled_speed_ = 0.0;  // [m/s]
  std::string name_;
  double max_speed_ = 0.0;  // that it may have [m/s]
  double goal_tolerance_ = 0.0;
  RobotSample last_;
  bool success_ = false;
  Vector2 arrival_ = Vector2::Zero();  // where it last arrived [m]

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

  MeasuredTime time_;
  MotionMeasures motion_;
  ContactMeasures contacts_;
  PeopleMeasures people_;
};

}  // namespace crowd
