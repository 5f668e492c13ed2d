#include "robots/log/robot_log_replay.h"

#include <algorithm>
#include <utility>

#include "robots/metrics/aggregated_time.h"
#include "social_crowd/errors.h"

namespace crowd {

RobotLogReplay::RobotLogReplay(const RobotLogHeader& header, const RobotMetricOptions& options)
    : header_(header), options_(options), walls_(header.walls) {
  scene_.tick_duration = header.tick_duration;
  scene_.walls = &walls_;
}

void RobotLogReplay::add(const RobotLogTick& tick) {
  if (tick.walls) walls_ = WallIndex(*tick.walls);
  if (!hasBegun()) return begin(tick);
  tick_ = tick.tick - first_tick_;
  takePeople(tick);
  moveRobots(tick);
  observe(tick);
  monitor_->observe(scene_);
}

void RobotLogReplay::begin(const RobotLogTick& tick) {
  first_tick_ = tick.tick;
  Scene scene;
  scene.tick_duration = header_.tick_duration;
  scene.robots = header_.robots;
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    scene.robots[i].drive = Drive::EXTERNAL;
    scene.robots[i].position = tick.robots[i].pose.position;
    scene.robots[i].heading = tick.robots[i].pose.heading;
  }
  robots_.emplace(scene);
  takePeople(tick);
  observe(tick);
  monitor_.emplace(options_, header_.gates, scene_);
}

void RobotLogReplay::takePeople(const RobotLogTick& tick) {
  people_.clear();
  for (const LoggedPerson& logged : tick.people) {
    Known& person = known_[logged.id];
    place(logged, person.last_seen && *person.last_seen + 1 == tick.tick, person);
    person.last_seen = tick.tick;
    people_.push_back(person.body);
  }
  for (const AgentId id : tick.arrived) known_[id].arrival = tick.tick - first_tick_;
}

/// @param was_there in the tick before; one who comes back has no velocity
void RobotLogReplay::place(const LoggedPerson& logged, bool was_there, Known& person) const {
  Agent& body = person.body;
  if (body.radius <= 0.0) {
    body.id = logged.id;
    body.radius = DEFAULT_LOGGED_RADIUS;
  }
  body.radius = logged.radius.value_or(body.radius);
  body.group = logged.group.value_or(body.group);
  person.endless = logged.endless.value_or(person.endless);
  const Vector2 way = was_there ? Vector2(logged.position - body.pose.position) : Vector2(Vector2::Zero());
  body.velocity = logged.velocity.value_or(way / header_.tick_duration);
  const double course = body.velocity.isZero(0.0) ? body.pose.heading : bearingOf(body.velocity);
  body.pose = {logged.position, logged.heading.value_or(course)};
}

void RobotLogReplay::moveRobots(const RobotLogTick& tick) {
  for (RobotId id = 0; id < tick.robots.size(); ++id) {
    const LoggedRobot& logged = tick.robots[id];
    const Vector2 way = logged.pose.position - (*robots_)[id].pose.position;
    try {
      robots_->place(id, logged.pose, logged.velocity.value_or(way / header_.tick_duration), false);
    } catch (const InputError& error) {
      throw InputError("robots[" + std::to_string(id) + "]: " + error.what());
    }
  }
  robots_->beginMoves(people_);
  robots_->noteGhostContacts({people_.data(), people_.size()}, header_.tick_duration);
  robots_->endMoves();
}

void RobotLogReplay::observe(const RobotLogTick& tick) {
  scene_.robots.clear();
  for (RobotId id = 0; id < tick.robots.size(); ++id) {
    const Robot& robot = (*robots_)[id];
    const LoggedRobot& logged = tick.robots[id];
    scene_.robots.push_back({&robot, logged.contacts ? &*logged.contacts : &robot.contacts, logged.impact});
  }
  scene_.people.clear();
  for (const Agent& person : people_) {
    scene_.people.push_back(
        {person.id, person.pose.position, person.pose.heading, person.velocity, person.radius, person.group});
  }
  scene_.obstacles = header_.obstacles;
  scene_.obstacles.insert(scene_.obstacles.end(), tick.obstacles.begin(), tick.obstacles.end());
}

double RobotLogReplay::timeOfPeople() const {
  std::uint64_t last = 0;
  for (const auto& [id, person] : known_) {
    if (person.endless && !person.arrival) continue;
    if (!person.arrival) return RobotResult::NONE;
    last = std::max(last, *person.arrival);
  }
  return static_cast<double>(last) * header_.tick_duration;
}

std::vector<RobotResult> RobotLogReplay::results() const {
  std::vector<RobotResult> results = monitor_->results();
  writeAggregatedTime(timeOfPeople(), results);
  return results;
}

}  // namespace crowd
