#include "robots/metrics/robot_sampler.h"

#include <algorithm>
#include <cmath>

#include "avoidance/time_to_collision.h"
#include "robots/metrics/interaction_force.h"

namespace crowd {
namespace {

/// Whether a contact began in this tick.
bool hasNewContact(const ObservedRobot& observed, const RobotSample& before, const RobotSample& now) {
  const auto begins = [](const RobotContact& contact) { return contact.begins; };
  return std::any_of(observed.contacts->begin(), observed.contacts->end(), begins) ||
         (now.at_wall && !before.at_wall) || (now.at_obstacle && !before.at_obstacle) ||
         (now.at_robot && !before.at_robot);
}

/// Whether an impact or a jump changed the velocity in this tick. Of an EXTERNAL robot only the poses are known.
bool hadImpact(const ObservedRobot& observed, const RobotSample& before, const RobotSample& now) {
  if (now.jumped) return true;
  if (observed.impact) return *observed.impact;
  const Robot& robot = *observed.robot;
  const bool is_external = robot.start.drive == Drive::EXTERNAL;
  return robot.blocked || (is_external && hasNewContact(observed, before, now));
}

/// Mean over the people of the forces of walls and obstacles [m/s^2].
double obstacleForceOnPeople(const ObservedScene& scene) {
  double sum = 0.0;
  for (const ObservedPerson& person : scene.people) sum += obstacleForce(Surroundings::clearanceOf(scene, person));
  return scene.people.empty() ? 0.0 : sum / static_cast<double>(scene.people.size());
}

double infiniteAsNone(double value) { return std::isinf(value) ? RobotSample::NONE : value; }

}  // namespace

void RobotSampler::begin(const ObservedScene& scene) {
  groups_.observe(scene);
  conflicts_.observe(scene);
  force_on_people_.reset();
}

RobotSample RobotSampler::measureStart(const ObservedScene& scene, RobotId id) {
  RobotSample sample;
  measurePlace(scene, id, sample);
  measureEncounters(scene, id, scene.robots[id].robot->next_goal, sample);
  sample.acceleration = 0.0;
  return sample;
}

RobotSample RobotSampler::measure(const ObservedScene& scene, RobotId id, const RobotSample& before, std::size_t goal) {
  RobotSample sample = follow(scene, id, before);
  measureEncounters(scene, id, goal, sample);
  if (sample.impact || before.jumped) return sample;  // a jump leaves no velocity
  const ResolvedConflicts resolved = conflicts_.resolved(scene, id, {before.velocity, sample.velocity});
  sample.conflict_by_robot = resolved.by_robot;
  sample.conflict_by_people = resolved.by_people;
  return sample;
}

RobotSample RobotSampler::follow(const ObservedScene& scene, RobotId id, const RobotSample& before) {
  const double duration = scene.tick_duration;
  RobotSample sample;
  measurePlace(scene, id, sample);
  sample.jumped = scene.robots[id].robot->jumped;
  if (!sample.jumped) sample.rotation = wrapAngle(sample.pose.heading - before.pose.heading) / duration;
  sample.impact = hadImpact(scene.robots[id], before, sample);
  if (sample.impact) return sample;
  sample.velocity_change = (sample.velocity - before.velocity) / duration;
  sample.acceleration = sample.velocity_change.norm();
  if (std::isnan(before.acceleration)) return sample;
  sample.jerk = (sample.velocity_change - before.velocity_change).norm() / duration;
  return sample;
}

void RobotSampler::measurePlace(const ObservedScene& scene, RobotId id, RobotSample& sample) {
  const Robot& robot = *scene.robots[id].robot;
  sample.pose = robot.pose;
  sample.velocity = scene.robots[id].velocity.value_or(robot.velocity);
  sample.speed = sample.velocity.norm();
  sample.in_group = groups_.isInside(robot, id);
  measureClearance(scene, robot, sample);
}

void RobotSampler::measureEncounters(const ObservedScene& scene, RobotId id, std::size_t goal, RobotSample& sample) {
  const Robot& robot = *scene.robots[id].robot;
  sample.goal = goal;
  if (robot.hasGoal()) {
    const Vector2 way = robot.goals[goal] - robot.pose.position;
    sample.goal_distance = way.norm();
    const bool is_there = way.isZero(0.0);  // where there is no direction to it
    sample.goal_angle = is_there ? 0.0 : std::abs(wrapAngle(bearingOf(way) - robot.pose.heading));
  }
  sample.people_contacts = scene.robots[id].contacts->size();
  measurePeople(scene, robot, sample);
  sample.group_distance = groups_.distanceFrom(robot, id);
  measureForces(scene, robot, sample);
}

void RobotSampler::measurePeople(const ObservedScene& scene, const Robot& robot, RobotSample& sample) {
  sample.people = scene.people.size();
  if (scene.people.empty()) return;
  const double reach = robot.start.footprint.reach();
  double nearest = INFINITE;
  double farthest = -INFINITE;
  double clearance = INFINITE;
  double time = NEVER;
  sample.people_speed = 0.0;
  for (const ObservedPerson& person : scene.people) {
    const double apart = distance(robot.start.footprint, robot.pose, person.position);
    const double speed = person.velocity.norm();
    clearance = std::min(clearance, apart - person.radius);
    farthest = std::max(farthest, apart);
    sample.people_speed += speed;
    time = std::min(time, timeToCollision(person.position - robot.pose.position, sample.velocity - person.velocity,
                                          reach + person.radius));
    if (apart >= nearest) continue;
    nearest = apart;
    sample.nearest_person_clearance = apart - person.radius;
    sample.nearest_person_speed = speed;
  }
  sample.nearest_person = nearest;
  sample.farthest_person = farthest;
  sample.people_clearance = clearance;
  if (time < NEVER) sample.time_to_collision = time;
}

void RobotSampler::measureClearance(const ObservedScene& scene, const Robot& robot, RobotSample& sample) {
  const double to_wall = surroundings_.wallDistance(scene, robot);
  const double to_obstacle = Surroundings::obstacleDistance(scene, robot);
  sample.obstacle_clearance = infiniteAsNone(std::min(to_wall, to_obstacle));
  sample.at_wall = to_wall < CONTACT_OVERLAP;
  sample.at_obstacle = to_obstacle < CONTACT_OVERLAP;
  sample.at_robot = std::any_of(scene.robots.begin(), scene.robots.end(), [&](const ObservedRobot& other) {
    return other.robot != &robot && distance(robot.start.footprint, robot.pose, other.robot->start.footprint,
                                             other.robot->pose) < CONTACT_OVERLAP;
  });
}

void RobotSampler::measureForces(const ObservedScene& scene, const Robot& robot, RobotSample& sample) {
  const ForceBody body{robot.pose.position, sample.velocity};
  Vector2 on_robot = Vector2::Zero();
  for (const ObservedPerson& person : scene.people) {
    const ForceBody other{person.position, person.velocity};
    const Vector2 force = interactionForce(body, other);
    on_robot += force;
    sample.social_force_on_robot += force.norm();
    sample.social_force_on_agents += interactionForce(other, body).norm();
  }
  const double clearance = std::isnan(sample.obstacle_clearance) ? INFINITE : sample.obstacle_clearance;
  sample.obstacle_force_on_robot = obstacleForce(clearance);
  if (!force_on_people_) force_on_people_ = obstacleForceOnPeople(scene);
  sample.obstacle_force_on_agents = *force_on_people_;
  sample.social_work = on_robot.norm() + sample.obstacle_force_on_robot + sample.social_force_on_agents;
}

}  // namespace crowd
