#include "robots/robot_monitor.h"

#include <utility>

#include "navigation/walking_floor.h"

namespace crowd {

RobotMonitor::RobotMonitor(const Scene& scene, const World& world)
    : options_(scene.robot_metrics), gates_(gateWalls(scene)) {
  if (!world.robots().empty()) add(world);
}

RobotMonitor::RobotMonitor(const RobotMetricOptions& options, std::vector<Segment> gates, const ObservedScene& start)
    : options_(options), gates_(std::move(gates)) {
  add(start);
}

void RobotMonitor::add(const World& world) {
  scene_.observe(world);
  add(scene_);
}

void RobotMonitor::add(const ObservedScene& scene) {
  sampler_.begin(scene);
  for (auto id = static_cast<RobotId>(tracks_.size()); id < scene.robots.size(); ++id) {
    const Robot& robot = *scene.robots[id].robot;
    RobotTrack& track = tracks_.emplace_back(options_, scene.tick_duration, robot, sampler_.measureStart(scene, id));
    if (robot.hasGoal()) track.setGoals(robot, waysOf(scene, robot));
    areas_.emplace_back(scene, gates_, robot.pose.position);
  }
  notePlaces(scene);
  measured_.resize(tracks_.size(), true);
}

void RobotMonitor::remove(RobotId robot) {
  tracks_.erase(tracks_.begin() + robot);
  areas_.erase(areas_.begin() + robot);
  measured_.erase(measured_.begin() + robot);
}

ShortestWay RobotMonitor::waysOf(const ObservedScene& scene, const Robot& robot) const {
  return {scene, gates_, robot.start.footprint};
}

void RobotMonitor::observe(const ObservedScene& scene) {
  bool has_begun = false;
  sampler_.begin(scene);
  for (RobotId id = 0; id < tracks_.size(); ++id) {
    RobotTrack& track = tracks_[id];
    const Robot& robot = *scene.robots[id].robot;
    if (robot.goals_set != track.goalsSet()) track.setGoals(robot, waysOf(scene, robot));
    measured_[id] = !track.hasArrived();
    if (track.hasArrived()) {
      track.follow(sampler_.follow(scene, id, track.last()));
      continue;
    }
    if (!std::exchange(has_begun, true)) notePlaces(scene);
    track.add(scene.robots[id], sampler_.measure(scene, id, track.last(), track.nextGoal()));
  }
}

void RobotMonitor::notePlaces(const ObservedScene& scene) {
  for (const ObservedRobot& observed : scene.robots) used_.extend(observed.robot->pose.position);
  for (const ObservedPerson& person : scene.people) used_.extend(person.position);
}

std::vector<RobotResult> RobotMonitor::results() const {
  std::vector<RobotResult> results;
  results.reserve(tracks_.size());
  for (RobotId id = 0; id < tracks_.size(); ++id) {
    RobotResult& result = results.emplace_back(tracks_[id].result());
    const double area = areas_[id].size(used_);
    if (area > 0.0) result.people_density = tracks_[id].meanPeople() / area;
  }
  return results;
}

}  // namespace crowd
