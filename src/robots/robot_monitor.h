#pragma once

#include <cstdint>
#include <vector>

#include "social_crowd/results.h"
#include "world/world.h"

namespace crowd {

/// @brief Measures the robots of a world tick by tick. The owner calls observe() after each tick.
class RobotMonitor {
 public:
  explicit RobotMonitor(const World& world);

  void observe(const World& world);
  std::vector<RobotResult> results() const;

 private:
  struct Track {
    RobotResult result;
    std::uint64_t ticks = 0;
    std::uint64_t ticks_with_people = 0;
    std::uint64_t intimate_ticks = 0;
    std::uint64_t personal_ticks = 0;  // intimate ones included
    std::uint64_t contact_ticks = 0;
    std::uint64_t still_ticks = 0;
    double straight_length = 0.0;
    double sum_of_speeds = 0.0;
    double sum_of_accelerations = 0.0;
    double sum_of_jerks = 0.0;
    double sum_of_clearances = 0.0;  // of the nearest person
    Pose start;
    Pose pose;
    Vector2 velocity = Vector2::Zero();
    Vector2 acceleration = Vector2::Zero();
    std::vector<Vector2> goals;
    std::vector<Vector2> recent;  // positions of the last 10 s, in a ring
    bool at_wall = false;
    bool at_robot = false;
  };

  void observeMotion(const Robot& robot, Track& track) const;
  void observePeople(const World& world, const Robot& robot, Track& track) const;
  void observeContacts(const World& world, const Robot& robot, Track& track);
  void setGoals(const Robot& robot, Track& track) const;
  bool isStuck(const Track& track) const;

  double tick_duration_;
  std::vector<Track> tracks_;
  std::vector<std::uint32_t> near_walls_;  // scratch
};

}  // namespace crowd
