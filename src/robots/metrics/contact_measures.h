#pragma once

#include <cstdint>
#include <vector>

#include "robots/metrics/beginnings.h"
#include "robots/metrics/measured_time.h"
#include "robots/metrics/observed_scene.h"
#include "robots/metrics/robot_sample.h"
#include "robots/metrics/statistic.h"
#include "social_crowd/robot_result.h"

namespace crowd {

/// @brief What a robot was in contact with in an episode, and how near it came to walls and obstacles.
class ContactMeasures {
 public:
  /// @brief Adds a tick.
  void add(const std::vector<RobotContact>& contacts, const RobotSample& sample) {
    wall_.add(sample.at_wall);
    obstacle_.add(sample.at_obstacle);
    other_robot_.add(sample.at_robot);
    obstacle_clearance_.addNumber(sample.obstacle_clearance);
    ticks_ += contacts.empty() ? 0 : 1;
    for (const RobotContact& contact : contacts) {
      if (!contact.begins) continue;
      by_robot_ += contact.cause == ContactCause::ROBOT ? 1 : 0;
      by_person_ += contact.cause == ContactCause::PERSON ? 1 : 0;
      mutual_ += contact.cause == ContactCause::MUTUAL ? 1 : 0;
    }
  }

  /// @brief Notes what the robot is at in a tick that does not count: only what begins later is counted.
  void note(const RobotSample& sample) {
    wall_.is_there = sample.at_wall;
    obstacle_.is_there = sample.at_obstacle;
    other_robot_.is_there = sample.at_robot;
  }

  void write(const MeasuredTime& time, RobotResult& result) const {
    result.robot_on_person_collisions = by_robot_;
    result.person_on_robot_collisions = by_person_;
    result.mutual_collisions = mutual_;
    result.people_contacts = result.collisions();
    result.contact_time = time.seconds(ticks_);
    result.wall_contacts = wall_.count;
    result.obstacle_contacts = obstacle_.count;
    result.robot_contacts = other_robot_.count;
    result.contacts = result.people_contacts + result.wall_contacts + result.obstacle_contacts + result.robot_contacts;
    result.minimum_obstacle_clearance = obstacle_clearance_.least();
    result.avg_obstacle_clearance = obstacle_clearance_.mean();
  }

 private:
  std::uint64_t by_robot_ = 0;  // contacts with people by cause
  std::uint64_t by_person_ = 0;
  std::uint64_t mutual_ = 0;
  std::uint64_t ticks_ = 0;  // in contact with people
  Beginnings wall_;
  Beginnings obstacle_;
  Beginnings other_robot_;
  Statistic obstacle_clearance_;
};

}  // namespace crowd
