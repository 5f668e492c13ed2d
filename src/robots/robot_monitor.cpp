#include "robots/robot_monitor.h"

#include <utility>

#include "navigation/walking_floor.h"

namespace crowd {

RobotMonitor::RobotMonitor(const Scene& scene, const World& world) {
  if (world.robots().empty()) return;
  gates_ = gateWalls(scene);
  scene_.observe(world);
  begin(scene.robot_metrics, scene_);
}

RobotMonitor::RobotMonitor(const RobotMetricOptions& options, std::vector<Segment> gates, const ObservedScene& start)
    : gates_(std::move(gates)) {
  begin(options, start);
}

void RobotMonitor::begin(const RobotMetricOptions& options, const ObservedScene& start) {
  sampler_.begin(start);
  for (RobotId id = 0; id < start.robots.size(); ++id) {
    const Robot& robot = *start.robots[id].robot;
    RobotTrack& track = tracks_.emplace_back(options, start.tick_duration, robot, sampler_.measureStart(start, id));
    if (robot.hasGoal()) track.setGoals(robot, waysOf(start, robot));
    areas_.emplace_back(start, gates_, robot.pose.position);
  }
  notePlaces(start);
  measured_.assign(tracks_.size(), true);
}

ShortestWay RobotMonitor::waysOf(const ObservedScene& scene, const Robot& robot) const {
  return {scene, gates_, robot.start.footprint};
}

void RobotMonitor::observe(const ObservedScene& scene) {
  bool has_begun = false;
  for (RobotId id = 0; id < tracks_.size(); ++id) {
    RobotTrack& track = tracks_[id];
    const Robot& robot = *scene.robots[id].robot;
    if (robot.goals != track.goals()) track.setGoals(robot, waysOf(scene, robot));
    measured_[id] = !track.hasArrived();
    if (track.hasArrived()) continue;
    if (!std::exchange(has_begun, true)) {
      sampler_.begin(scene);
      notePlaces(scene);
    }
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
