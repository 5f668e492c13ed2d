#include "robots/robot_senses.h"

#include <algorithm>

namespace crowd {
namespace {

/// A robot that moves farther in a tick than this share of what its speed allows was moved by somebody.
constexpr double MOVED_SHARE = 1.5;

Pose sensorPose(const Pose& robot, const Pose& mount) {
  return {robot.position + Rotation(robot.heading).outOfFrame(mount.position), robot.heading + mount.heading};
}

TrackSpec trackSpecOf(const RobotStart& start, bool hides_people) {
  TrackSpec spec = start.tracks;
  spec.occlusion = spec.occlusion || hides_people;
  return spec;
}

/// The variances of the three errors of an odometry, as a diagonal matrix.
Eigen::Matrix3d variancesOf(const OdometrySpec& spec) {
  return Eigen::Vector3d(spec.distance, spec.rotation, spec.heading_per_metre).cwiseAbs2().asDiagonal();
}

}  // namespace

RobotSenses::RobotSenses(const Scene& scene, bool hides_people)
    : seed_(scene.population_seed), hides_people_(hides_people), map_(scene.map) {
  for (const RobotStart& start : scene.robots) add(start);
}

void RobotSenses::add(const RobotStart& start) {
  has_legs_ = has_legs_ || start.scan.people == SeenPeople::LEGS;
  const std::uint64_t number = next_number_++;
  Sensor& sensor = sensors_.emplace_back(
      start, number,
      PersonTracker(trackSpecOf(start, hides_people_), KeyedRandom(seed_, KeyedRandom::TRACKS, {number}),
                    std::min(start.tracks.range, start.scan.max_range)));
  KeyedRandom random(seed_, KeyedRandom::ODOMETRY, {sensor.number});
  sensor.distance_factor += start.odometry.distance * random.normal();
  sensor.rotation_factor += start.odometry.rotation * random.normal();
  sensor.heading_per_metre = start.odometry.heading_per_metre * random.normal();
}

void RobotSenses::observe(const World& world) {
  if (has_legs_) gait_.observe(world);
  for (std::size_t i = 0; i < sensors_.size(); ++i) measureMove(world.robots()[i], world.tickDuration(), sensors_[i]);
}

void RobotSenses::measureMove(const Robot& robot, double tick_duration, Sensor& sensor) {
  const Vector2 way = Rotation(sensor.last_pose.heading).intoFrame(robot.pose.position - sensor.last_pose.position);
  const double turn = wrapAngle(robot.pose.heading - sensor.last_pose.heading);
  sensor.last_pose = robot.pose;
  const Twist& twist = robot.twist;
  const double drift = sensor.heading_per_metre * twist.linear.norm();
  sensor.odometry.twist = {sensor.distance_factor * twist.linear, sensor.rotation_factor * twist.rotation + drift};
  if (way.norm() > MOVED_SHARE * robot.start.limits.max_speed * tick_duration) return;
  Pose& pose = sensor.odometry.pose;
  const Vector2 step = Rotation(pose.heading).outOfFrame(sensor.distance_factor * way);
  // An error of the heading turns the step; that of distances changes its length.
  sensor.derivative.topRows<2>() += Vector2(-step.y(), step.x()) * sensor.derivative.row(2);
  sensor.derivative.topRows<2>().col(0) += step / sensor.distance_factor;
  sensor.derivative.row(2) += Eigen::RowVector3d(0.0, turn, way.norm());
  pose.position += step;
  pose.heading = wrapAngle(pose.heading + sensor.rotation_factor * turn + sensor.heading_per_metre * way.norm());
}

const std::vector<float>& RobotSenses::ranges(const World& world, RobotId robot) {
  scan(world, robot);
  return sensors_[robot].ranges;
}

const std::vector<bool>& RobotSenses::visibleBodies(const World& world, RobotId robot) {
  scan(world, robot);
  Sensor& sensor = sensors_[robot];
  sensor.seen.assign(world.agents().size() + world.obstacles().size(), false);
  markVisible(sensor.scanner.last(), sensor.seen);
  return sensor.seen;
}

const std::vector<PersonTrack>& RobotSenses::tracks(const World& world, RobotId robot) {
  Sensor& sensor = sensors_[robot];
  if (sensor.tracked_at == world.tick()) return sensor.tracks;
  sensor.tracked_at = world.tick();
  TrackerView view;
  view.sensor = sensorPose(world.robots()[robot].pose, sensor.scanner.spec().mount).position;
  if (sensor.tracker.spec().occlusion) {
    view.visible = &visibleBodies(world, robot);
    view.scanner = &sensor.scanner;
  }
  sensor.tracks = sensor.tracker.update(world, view, map_.get());
  return sensor.tracks;
}

void RobotSenses::forgetScans() {
  for (Sensor& sensor : sensors_) sensor.scanned_at.reset();
}

OdometryCovariance RobotSenses::covariance(RobotId robot) const {
  const Sensor& sensor = sensors_[robot];
  const Eigen::Matrix3d variances = variancesOf(sensor.deviations);
  Eigen::Matrix3d twist = Eigen::Matrix3d::Zero();  // derivative with respect to the three errors
  twist.topRows<2>().col(0) = sensor.odometry.twist.linear / sensor.distance_factor;
  twist(2, 1) = sensor.odometry.twist.rotation;
  twist(2, 2) = sensor.odometry.twist.linear.norm();
  return {sensor.derivative * variances * sensor.derivative.transpose(), twist * variances * twist.transpose()};
}

void RobotSenses::scan(const World& world, RobotId robot) {
  Sensor& sensor = sensors_[robot];
  if (sensor.scanned_at == world.tick()) return;
  sensor.scanned_at = world.tick();
  updateWalls(world);
  const ScanSpec& spec = sensor.scanner.spec();
  targets_.clear();
  edges_.clear();
  addPeople(world, spec.people);
  addObstacles(world, spec.people);
  addRobots(world, robot);
  const Scan& scan = sensor.scanner.scan(sensorPose(world.robots()[robot].pose, spec.mount),
                                         {targets_.data(), targets_.size()}, {edges_.data(), edges_.size()}, walls_);
  writeRanges(scan, spec, KeyedRandom(seed_, KeyedRandom::SENSOR, {sensor.number, world.tick()}), sensor.ranges);
}

void RobotSenses::updateWalls(const World& world) {
  if (walls_of_ == world.layoutChanges()) return;
  walls_ = WallIndex(world.walls().list());
  walls_of_ = world.layoutChanges();
}

std::vector<ScanPoint> RobotSenses::points(const World& world, RobotId robot) {
  updateWalls(world);
  std::vector<Column> columns;
  std::vector<Panel> panels;
  for (const Agent& agent : world.agents()) {
    if (!agent.isPresent()) continue;
    columns.push_back({agent.pose.position, agent.radius, heightOf(agent.figure), solids::PERSON_REFLECTION});
  }
  for (const Obstacle& obstacle : world.obstacles()) {
    if (!world.isPresent(obstacle)) continue;
    const bool is_person = obstacle.person.has_value();
    columns.push_back({obstacle.path.at(world.time()).position, obstacle.radius,
                       is_person ? solids::ADULT_HEIGHT : solids::OBSTACLE_HEIGHT,
                       is_person ? solids::PERSON_REFLECTION : solids::BODY_REFLECTION});
  }
  for (RobotId other = 0; other < world.robots().size(); ++other) {
    if (other == robot) continue;
    const Footprint& footprint = world.robots()[other].start.footprint;
    const Pose& pose = world.robots()[other].pose;
    if (footprint.isDisc()) {
      columns.push_back({pose.position, footprint.radius, solids::ROBOT_HEIGHT, solids::BODY_REFLECTION});
    }
    const std::vector<Vector2> corners = footprint.cornersAt(pose);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      panels.push_back(
          {{corners[i], corners[(i + 1) % corners.size()]}, solids::ROBOT_HEIGHT, solids::BODY_REFLECTION});
    }
  }
  const Sensor& sensor = sensors_[robot];
  const ScanSpec& spec = sensor.scanner.spec();
  return scanRings(spec, sensorPose(world.robots()[robot].pose, spec.mount), {columns.data(), columns.size()},
                   {panels.data(), panels.size()}, walls_,
                   KeyedRandom(seed_, KeyedRandom::SENSOR, {sensor.number, world.tick()}));
}

void RobotSenses::addPeople(const World& world, SeenPeople people) {
  for (BodyNumber body = 0; body < world.agents().size(); ++body) {
    const Agent& agent = world.agents().nth(body);
    if (!agent.isPresent()) continue;
    if (people == SeenPeople::LEGS) {
      addLegs(agent.pose, gait_.walked(agent.id), agent.radius, body, targets_);
    } else {
      targets_.push_back({agent.pose.position, agent.radius, body});
    }
  }
}

void RobotSenses::addObstacles(const World& world, SeenPeople people) {
  auto body = static_cast<BodyNumber>(world.agents().size());
  for (const Obstacle& obstacle : world.obstacles()) {
    const BodyNumber number = body++;
    if (!world.isPresent(obstacle)) continue;
    const PathMotion motion = obstacle.path.at(world.time());
    const Track* const track = obstacle.path.track();
    if (people == SeenPeople::LEGS && track != nullptr) {
      addLegs({motion.position, bearingOf(motion.velocity)}, track->walked(world.time()), obstacle.radius, number,
              targets_);
    } else {
      targets_.push_back({motion.position, obstacle.radius, number});
    }
  }
}

void RobotSenses::addRobots(const World& world, RobotId robot) {
  auto body = static_cast<BodyNumber>(world.agents().size() + world.obstacles().size());
  for (RobotId other = 0; other < world.robots().size(); ++other, ++body) {
    if (other == robot) continue;
    const Pose& pose = world.robots()[other].pose;
    const Footprint& footprint = world.robots()[other].start.footprint;
    if (footprint.isDisc()) targets_.push_back({pose.position, footprint.radius, body});
    const std::vector<Vector2> corners = footprint.cornersAt(pose);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      edges_.push_back({{corners[i], corners[(i + 1) % corners.size()]}, body});
    }
  }
}

}  // namespace crowd
