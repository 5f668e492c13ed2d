#include "robots/robot_monitor.h"

#include <algorithm>
#include <cmath>

namespace crowd {
namespace {

constexpr double STUCK_TIME = 10.0;         // [s]
constexpr double STUCK_DISTANCE = 0.5;      // [m]
constexpr double STILL_SPEED = 0.001;       // [m/s]
constexpr double STILL_ROTATION = 0.01;     // [rad/s]
constexpr double INTIMATE_DISTANCE = 0.45;  // [m]
constexpr double PERSONAL_DISTANCE = 1.2;   // [m]

/// Number of the positions that span STUCK_TIME.
std::size_t rememberedCount(double tick_duration) {
  return static_cast<std::size_t>(std::ceil(STUCK_TIME / tick_duration)) + 1;
}

/// The smaller of two numbers; `value` if there is none yet.
double smaller(double so_far, double value) { return std::isnan(so_far) ? value : std::min(so_far, value); }

double meanOf(double sum, std::uint64_t count) {
  return count == 0 ? RobotResult::NONE : sum / static_cast<double>(count);
}

void countCollisions(const Robot& robot, RobotResult& result) {
  for (const RobotContact& contact : robot.contacts) {
    if (!contact.begins) continue;
    if (contact.cause == ContactCause::ROBOT) ++result.robot_on_person_collisions;
    if (contact.cause == ContactCause::PERSON) ++result.person_on_robot_collisions;
    if (contact.cause == ContactCause::MUTUAL) ++result.mutual_collisions;
  }
}

}  // namespace

RobotMonitor::RobotMonitor(const World& world) : tick_duration_(world.tickDuration()) {
  for (const Robot& robot : world.robots()) {
    Track& track = tracks_.emplace_back();
    track.result.name = robot.start.name;
    track.start = robot.pose;
    track.pose = robot.pose;
    track.recent.reserve(rememberedCount(tick_duration_));
    setGoals(robot, track);
  }
}

/// The straight length leads from the start via the present position to the goals.
void RobotMonitor::setGoals(const Robot& robot, Track& track) const {
  track.goals = robot.goals;
  if (!robot.hasGoal()) return;
  Vector2 from = track.pose.position;
  track.straight_length = (from - track.start.position).norm() - robot.start.goal_tolerance;
  for (const Vector2& goal : robot.goals) {
    track.straight_length += (goal - from).norm();
    from = goal;
  }
}

void RobotMonitor::observe(const World& world) {
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    Track& track = tracks_[i];
    const Robot& robot = world.robots()[i];
    if (robot.goals != track.goals) {
      setGoals(robot, track);
      track.result.success = false;
    }
    if (track.result.success) continue;
    ++track.ticks;
    observeContacts(world, robot, track);
    observePeople(world, robot, track);
    observeMotion(robot, track);
    track.result.success = robot.hasArrived();
  }
}

void RobotMonitor::observeMotion(const Robot& robot, Track& track) const {
  RobotResult& result = track.result;
  result.path_length += (robot.pose.position - track.pose.position).norm();
  const double turn = std::abs(wrapAngle(robot.pose.heading - track.pose.heading));
  result.cumulative_heading_changes += turn;
  const Vector2 acceleration = (robot.velocity - track.velocity) / tick_duration_;
  const double jerk = (acceleration - track.acceleration).norm() / tick_duration_;
  const double speed = robot.velocity.norm();
  track.sum_of_speeds += speed;
  track.sum_of_accelerations += acceleration.norm();
  track.sum_of_jerks += jerk;
  result.max_speed = std::max(result.max_speed, speed);
  result.max_acceleration = std::max(result.max_acceleration, acceleration.norm());
  result.max_jerk = std::max(result.max_jerk, jerk);
  const bool is_still = speed < STILL_SPEED && turn < STILL_ROTATION * tick_duration_;
  track.still_ticks += is_still ? 1 : 0;
  track.pose = robot.pose;
  track.velocity = robot.velocity;
  track.acceleration = acceleration;
  const std::size_t remembered = rememberedCount(tick_duration_);
  if (track.recent.size() < remembered) {
    track.recent.push_back(robot.pose.position);
  } else {
    track.recent[(track.ticks - 1) % remembered] = robot.pose.position;
  }
  if (!robot.hasGoal()) return;
  result.final_distance = (robot.goals.back() - robot.pose.position).norm();
  result.minimum_distance_to_goal = smaller(result.minimum_distance_to_goal, result.final_distance);
}

void RobotMonitor::observePeople(const World& world, const Robot& robot, Track& track) const {
  RobotResult& result = track.result;
  double nearest = std::numeric_limits<double>::infinity();
  double its_radius = 0.0;
  const auto see = [&](const Vector2& place, double radius) {
    const double apart = distance(robot.start.footprint, robot.pose, place);
    result.minimum_clearance = smaller(result.minimum_clearance, apart - radius);
    if (apart >= nearest) return;
    nearest = apart;
    its_radius = radius;
  };
  for (const Agent& agent : world.agents()) {
    if (agent.isPresent()) see(agent.pose.position, agent.radius);
  }
  for (const Neighbour& person : world.recordedPeople()) see(person.position, person.radius);
  if (std::isinf(nearest)) return;
  ++track.ticks_with_people;
  track.sum_of_clearances += nearest - its_radius;
  track.intimate_ticks += nearest < INTIMATE_DISTANCE ? 1 : 0;
  track.personal_ticks += nearest < PERSONAL_DISTANCE ? 1 : 0;
  result.minimum_distance_to_people = smaller(result.minimum_distance_to_people, nearest);
}

void RobotMonitor::observeContacts(const World& world, const Robot& robot, Track& track) {
  RobotResult& result = track.result;
  countCollisions(robot, result);
  track.contact_ticks += robot.contacts.empty() ? 0 : 1;
  const Footprint& footprint = robot.start.footprint;
  near_walls_.clear();
  world.walls().index().findNear(robot.pose.position, footprint.reach() + CONTACT_OVERLAP, near_walls_);
  const bool at_wall = std::any_of(near_walls_.begin(), near_walls_.end(), [&](std::uint32_t number) {
    return distance(footprint, robot.pose, world.walls().list()[number]) < CONTACT_OVERLAP;
  });
  const bool at_robot = std::any_of(world.robots().begin(), world.robots().end(), [&](const Robot& other) {
    return &other != &robot && distance(footprint, robot.pose, other.start.footprint, other.pose) < CONTACT_OVERLAP;
  });
  result.wall_contacts += at_wall && !track.at_wall ? 1 : 0;
  result.robot_contacts += at_robot && !track.at_robot ? 1 : 0;
  track.at_wall = at_wall;
  track.at_robot = at_robot;
}

bool RobotMonitor::isStuck(const Track& track) const {
  const std::size_t remembered = rememberedCount(tick_duration_);
  if (track.recent.size() < remembered) return false;
  const Vector2& earliest = track.recent[track.ticks % remembered];
  return (track.pose.position - earliest).norm() < STUCK_DISTANCE;
}

std::vector<RobotResult> RobotMonitor::results() const {
  std::vector<RobotResult> results;
  results.reserve(tracks_.size());
  for (const Track& track : tracks_) {
    RobotResult result = track.result;
    const auto seconds = [&](std::uint64_t ticks) { return static_cast<double>(ticks) * tick_duration_; };
    const auto percent = [&](std::uint64_t ticks) { return meanOf(100.0 * static_cast<double>(ticks), track.ticks); };
    result.timeout = !track.goals.empty() && !result.success;
    result.stuck = result.timeout && isStuck(track);
    if (result.success) result.time_to_reach_goal = seconds(track.ticks);
    if (track.straight_length > 0.0) result.path_length_ratio = result.path_length / track.straight_length;
    result.avg_robot_linear_speed = meanOf(track.sum_of_speeds, track.ticks);
    result.avg_acceleration = meanOf(track.sum_of_accelerations, track.ticks);
    result.avg_jerk = meanOf(track.sum_of_jerks, track.ticks);
    result.time_not_moving = seconds(track.still_ticks);
    result.contact_time = seconds(track.contact_ticks);
    result.avg_closest_person = meanOf(track.sum_of_clearances, track.ticks_with_people);
    result.intimate_space_time = seconds(track.intimate_ticks);
    result.personal_space_time = seconds(track.personal_ticks);
    result.intimate_space_intrusions = percent(track.intimate_ticks);
    result.personal_space_intrusions = percent(track.personal_ticks - track.intimate_ticks);
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace crowd
