#include "robots/log/robot_log_replay.h"

#include <algorithm>
#include <string>
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
  for (RobotId id = 0; id < tick.robots.size(); ++id) {
    const Vector2 unknown = Vector2::Constant(RobotSample::NONE);
    scene_.robots[id].velocity = tick.robots[id].velocity.value_or(unknown);
  }
  monitor_.emplace(options_, header_.gates, scene_);
}

void RobotLogReplay::takePeople(const RobotLogTick& tick) {
  people_.clear();
  motions_.clear();
  for (const LoggedPerson& logged : tick.people) {
    Known& person = known_[logged.id];
    const Vector2 way = place(logged, person.last_seen && *person.last_seen + 1 == tick.tick, person);
    person.last_seen = tick.tick;
    people_.push_back(person.body);
    motions_.push_back({logged.id, person.body.radius, logged.position - way, way});
  }
  requireKnown(tick);
  for (const AgentId id : tick.arrived) known_[id].arrival = tick.tick - first_tick_;
}

void RobotLogReplay::requireKnown(const RobotLogTick& tick) const {
  const auto require = [&](AgentId id, const std::string& path) {
    if (known_.count(id) > 0) return;
    throw InputError(path + ": there has been no person " + std::to_string(id) + " in 'people'");
  };
  for (std::size_t i = 0; i < tick.arrived.size(); ++i) {
    require(tick.arrived[i], "arrived[" + std::to_string(i) + "]");
  }
  for (std::size_t i = 0; i < tick.robots.size(); ++i) {
    if (!tick.robots[i].contacts) continue;
    const std::vector<RobotContact>& contacts = *tick.robots[i].contacts;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      require(contacts[k].agent, "robots[" + std::to_string(i) + "].contacts[" + std::to_string(k) + "].person");
    }
  }
}

/// One who comes back has no velocity.
Vector2 RobotLogReplay::place(const LoggedPerson& logged, bool was_there, Known& person) const {
  Agent& body = person.body;
  if (body.radius <= 0.0) {
    body.id = logged.id;
    body.radius = DEFAULT_LOGGED_RADIUS;
  }
  body.radius = logged.radius.value_or(body.radius);
  body.group = logged.group.value_or(body.group);
  person.endless = logged.endless.value_or(person.endless);
  Vector2 way = was_there ? Vector2(logged.position - body.pose.position) : Vector2(Vector2::Zero());
  body.velocity = logged.velocity.value_or(way / header_.tick_duration);
  const double course = body.velocity.isZero(0.0) ? body.pose.heading : bearingOf(body.velocity);
  body.pose = {logged.position, logged.heading.value_or(course)};
  return way;
}

void RobotLogReplay::moveRobots(const RobotLogTick& tick) {
  for (RobotId id = 0; id < tick.robots.size(); ++id) {
    const LoggedRobot& logged = tick.robots[id];
    if (logged.jump) robots_->teleport(id, logged.pose);
    const Vector2 way = logged.pose.position - (*robots_)[id].pose.position;
    try {
      robots_->place(id, logged.pose, logged.velocity.value_or(way / header_.tick_duration), false);
    } catch (const InputError& error) {
      throw InputError("robots[" + std::to_string(id) + "]: " + error.what());
    }
  }
  robots_->beginMoves(people_);
  robots_->noteGhostContacts(motions_);
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
