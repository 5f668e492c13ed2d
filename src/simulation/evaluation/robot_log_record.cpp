#include "simulation/evaluation/robot_log_record.h"

#include <algorithm>

#include "navigation/walking_floor.h"
#include "robots/log/robot_log_writing.h"

namespace crowd {
namespace {

/// Keeps a value only if it is not the one that was last written.
template <typename Value>
void leaveOutIfSame(std::optional<Value>& written, std::optional<Value>& value) {
  if (written == value) {
    value.reset();
  } else {
    written = value;
  }
}

/// Leaves out people who have left in the tick: in a part of a log that begins with it, nothing is known about them.
void leaveOutTheGone(RobotLogTick& tick) {
  tick.arrived.clear();
  const auto is_gone = [&](const RobotContact& contact) {
    return std::none_of(tick.people.begin(), tick.people.end(),
                        [&](const LoggedPerson& person) { return person.id == contact.agent; });
  };
  for (LoggedRobot& robot : tick.robots) {
    if (!robot.contacts) continue;
    robot.contacts->erase(std::remove_if(robot.contacts->begin(), robot.contacts->end(), is_gone),
                          robot.contacts->end());
  }
}

}  // namespace

void RobotLogRecord::append(std::uint64_t number, const Episode& episode, std::string& text) {
  const World& world = episode.world();
  if (world.robots().empty()) return;
  scene_.observe(world);
  const bool has_header = headed_ == world.robots().changes();
  if (!has_header) {
    headed_ = world.robots().changes();
    written_.clear();
    layout_changes_ = world.layoutChanges();
    appendLogLine(headerOf(number, episode), text);
  }
  RobotLogTick tick = tickOf(episode);
  if (!has_header && world.tick() > 0) leaveOutTheGone(tick);
  appendLogLine(tick, text);
}

RobotLogHeader RobotLogRecord::headerOf(std::uint64_t number, const Episode& episode) const {
  const Scene& scene = episode.scene();
  RobotLogHeader header;
  header.scenario = scene.name;
  header.episode = number;
  header.map = scene.map_file;
  header.tick_duration = scene.tick_duration;
  header.walls = episode.world().walls().list();
  header.gates = gateWalls(scene);
  std::copy_if(scene_.obstacles.begin(), scene_.obstacles.end(), std::back_inserter(header.obstacles),
               [](const ObservedObstacle& obstacle) { return !obstacle.moves; });
  for (const Robot& robot : episode.world().robots()) {
    RobotStart& start = header.robots.emplace_back(robot.start);
    start.goals.assign(robot.goals.begin() + static_cast<std::ptrdiff_t>(robot.next_goal), robot.goals.end());
  }
  return header;
}

RobotLogTick RobotLogRecord::tickOf(const Episode& episode) {
  const World& world = episode.world();
  RobotLogTick tick;
  tick.tick = world.tick();
  for (RobotId id = 0; id < world.robots().size(); ++id) {
    const Robot& robot = world.robots()[id];
    LoggedRobot& logged = tick.robots.emplace_back();
    logged.pose = robot.pose;
    logged.velocity = robot.velocity;
    logged.contacts = robot.contacts;
    logged.jump = robot.jumped;
    const RobotSample* const sample = episode.robotMonitor().sampleOf(id);
    if (sample != nullptr) logged.impact = sample->impact;
  }
  for (const ObservedPerson& person : scene_.people) tick.people.push_back(personOf(episode, person));
  for (const Agent& agent : world.agents()) {
    if (agent.hasArrived() && agent.arrival_tick == world.tick()) tick.arrived.push_back(agent.id);
  }
  std::copy_if(scene_.obstacles.begin(), scene_.obstacles.end(), std::back_inserter(tick.obstacles),
               [](const ObservedObstacle& obstacle) { return obstacle.moves; });
  if (world.layoutChanges() != layout_changes_) tick.walls = world.walls().list();
  layout_changes_ = world.layoutChanges();
  return tick;
}

LoggedPerson RobotLogRecord::personOf(const Episode& episode, const ObservedPerson& observed) {
  LoggedPerson person;
  person.id = observed.id;
  person.position = observed.position;
  person.heading = observed.heading;
  person.velocity = observed.velocity;
  person.radius = observed.radius;
  if (observed.group != NO_GROUP) person.group = observed.group;
  const Agent* const agent = episode.world().agents().find(observed.id);
  if (agent != nullptr) person.goal = agent->goal();
  // A recorded person is no agent of the episode, which is to arrive.
  const EpisodeMonitor::Track* const track = episode.monitor().tracks().find(observed.id);
  if (track == nullptr || track->result.endless) person.endless = true;
  LoggedPerson& written = written_[observed.id];
  leaveOutIfSame(written.radius, person.radius);
  leaveOutIfSame(written.group, person.group);
  if (written.endless && !person.endless) person.endless = false;
  leaveOutIfSame(written.endless, person.endless);
  return person;
}

}  // namespace crowd
