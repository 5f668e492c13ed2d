#include "world/robots.h"

#include <algorithm>
#include <utility>

#include "common/text/numbers.h"
#include "common/text/quotes.h"
#include "geometry/finite_checks.h"
#include "geometry/impact.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

/// A disc touches nothing by turning, so it goes on to turn for the rest of the tick [s]; other robots stand.
void stopAtImpact(Robot& robot, double rest) {
  const bool turns = robot.start.footprint.isDisc() && robot.start.drive != Drive::ACKERMANN;
  robot.twist = {Vector2::Zero(), turns ? robot.twist.rotation : 0.0};
  robot.pose.heading = wrapAngle(robot.pose.heading + rest * robot.twist.rotation);
}

/// A robot with the protective stop stops at walls: the stop does not foresee where it would slide.
std::optional<WallSliding> slidingOf(const RobotStart& robot) {
  if (robot.drive == Drive::EXTERNAL || doesRobotYield(robot.yields)) return std::nullopt;
  return WallSliding{robot.limits.max_rotation, robot.drive != Drive::ACKERMANN};
}

/// The cause of a contact if robot and person move as they intend: a side moves in if its motion alone touches the
/// other side at the place of the start of the tick. @param start of the person [m] @param way of the person in the
/// tick [m]
ContactCause causeOf(const RobotSweep& sweep, const Vector2& start, const Vector2& way, double radius) {
  const Pose pose = sweep.at(0.0);
  const RobotSweep standing(sweep.footprint(), pose, pose);
  const bool robot_moves_in = firstTouch(sweep, start, Vector2::Zero(), radius, 0.0) < NO_IMPACT;
  const bool person_moves_in = firstTouch(standing, start, way, radius, 0.0) < NO_IMPACT;
  if (robot_moves_in == person_moves_in) return ContactCause::MUTUAL;
  return robot_moves_in ? ContactCause::ROBOT : ContactCause::PERSON;
}

bool overlaps(const RobotSweep& sweep, const Vector2& place, double radius) {
  return distance(sweep.footprint(), sweep.at(0.0), place) < radius;
}

}  // namespace

Robots::Robots(const Scene& scene) : tick_duration_(scene.tick_duration), contact_(scene.contact) {
  for (const RobotStart& start : scene.robots) add(start);
}

RobotId Robots::add(const RobotStart& start) {
  ++changes_;
  Robot& robot = robots_.emplace_back();
  robot.start = start;
  robot.pose = {start.position, wrapAngle(start.heading)};
  robot.goals = start.goals;
  robot.perceived_radius = start.footprint.reach() + deviation(start.limits, tick_duration_);
  commands_.emplace_back();
  places_.emplace_back();
  contacts_.emplace_back();
  return static_cast<RobotId>(robots_.size() - 1);
}

void Robots::remove(RobotId id) {
  require(id);
  ++changes_;
  robots_.erase(robots_.begin() + id);
  commands_.erase(commands_.begin() + id);
  places_.erase(places_.begin() + id);
  contacts_.erase(contacts_.begin() + id);
}

const Robot& Robots::require(RobotId id) const {
  if (id >= robots_.size()) throw InputError("there is no robot " + std::to_string(id));
  return robots_[id];
}

RobotId Robots::idOf(const std::string& name) const {
  const auto found =
      std::find_if(robots_.begin(), robots_.end(), [&](const Robot& robot) { return robot.start.name == name; });
  if (found == robots_.end()) throw InputError("there is no robot " + inQuotes(name));
  return static_cast<RobotId>(found - robots_.begin());
}

Robot& Robots::find(RobotId id) {
  require(id);
  return robots_[id];
}

void Robots::command(RobotId id, const Twist& wanted) {
  const Robot& robot = require(id);
  const std::string name = "robot " + inQuotes(robot.start.name);
  if (robot.start.drive == Drive::EXTERNAL) throw InputError(name + " is external: it takes no commands");
  if (!wanted.isFinite()) {
    throw InputError(name + ": expected a command of finite numbers, got linear " +
                     toText(std::vector<double>{wanted.linear.x(), wanted.linear.y()}) + ", rotation " +
                     toText(wanted.rotation));
  }
  commands_[id] = wanted;
}

void Robots::place(RobotId id, const Pose& pose, const Vector2& velocity, bool jump) {
  const Robot& robot = require(id);
  if (robot.start.drive != Drive::EXTERNAL) {
    throw InputError("robot " + inQuotes(robot.start.name) + " is not external: it moves by commands");
  }
  requirePose(pose);
  requireWithin(limits::VELOCITY, "velocity [m/s]", velocity);
  places_[id] = Place{{pose.position, wrapAngle(pose.heading)}, velocity, jump};
}

void Robots::setGoals(RobotId id, std::vector<Vector2> goals) {
  Robot& robot = find(id);
  for (const Vector2& goal : goals) requirePlace("goal [m]", goal);
  robot.goals = std::move(goals);
  robot.next_goal = 0;
  ++robot.goals_set;
  ++changes_;
  robot.status = RobotStatus::DRIVING;
}

void Robots::send(RobotId id, const Vector2& goal) {
  setGoals(id, {goal});
  robots_[id].sent = true;
}

void Robots::teleport(RobotId id, const Pose& pose) {
  Robot& robot = find(id);
  robot.pose = {pose.position, wrapAngle(pose.heading)};
  robot.twist = Twist();
  robot.velocity = Vector2::Zero();
  robot.teleported = true;
  places_[id].reset();
}

bool Robots::isAnyWithin(double distance, const Vector2& place) const {
  return std::any_of(robots_.begin(), robots_.end(), [&](const Robot& robot) {
    return crowd::distance(robot.start.footprint, robot.pose, place) < distance;
  });
}

std::string Robots::blockerAt(const Vector2& centre, double radius, std::optional<RobotId> except) const {
  for (RobotId id = 0; id < robots_.size(); ++id) {
    const Robot& robot = robots_[id];
    if (id == except || distance(robot.start.footprint, robot.pose, centre) >= radius) continue;
    return "robot " + inQuotes(robot.start.name);
  }
  return "";
}

void Robots::beginMoves(const std::vector<Agent>& agents, const std::vector<Neighbour>& recorded) {
  sweeps_.clear();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = robots_[i];
    robot.target = commands_[i];
    robot.blocked = false;
    robot.jumped = std::exchange(robot.teleported, false);
    const Footprint& footprint = robot.start.footprint;
    if (robot.start.drive != Drive::EXTERNAL) {
      robot.twist = doesRobotYield(robot.start.yields)
                        ? protective_stop_.next(robot, agents, recorded, tick_duration_)
                        : limitTwist(robot.start.drive, robot.start.limits, robot.twist, robot.target, tick_duration_);
      sweeps_.emplace_back(footprint, robot.pose, robot.twist, tick_duration_);
      continue;
    }
    robot.velocity = Vector2::Zero();
    Pose from = robot.pose;
    if (const auto place = std::exchange(places_[i], std::nullopt)) {
      robot.pose = place->pose;
      if (place->jump) {
        robot.jumped = true;
        from = robot.pose;
      } else {
        robot.velocity = place->velocity;
      }
    }
    sweeps_.emplace_back(footprint, from, robot.pose);
  }
}

void Robots::hold() {
  sweeps_.clear();
  for (const Robot& robot : robots_) sweeps_.emplace_back(robot.start.footprint, robot.pose, Twist(), tick_duration_);
}

void Robots::addDiscs(std::vector<SolidMotion::Disc>& discs) const {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const RobotSweep& sweep = sweeps_[i];
    const bool can_stop = robots_[i].start.drive != Drive::EXTERNAL;
    discs.push_back({sweep.at(0.0).position, Vector2::Zero(), sweep.footprint().reach(), can_stop, &sweep,
                     slidingOf(robots_[i].start)});
  }
}

void Robots::noteContact(RobotId id, const PersonMotion& person) {
  const auto is_with = [&](const RobotContact& contact) { return contact.agent == person.id; };
  std::vector<RobotContact>& present = contacts_[id];
  if (std::any_of(present.begin(), present.end(), is_with)) return;
  const Robot& robot = robots_[id];
  const auto earlier = std::find_if(robot.contacts.begin(), robot.contacts.end(), is_with);
  if (earlier != robot.contacts.end()) {
    present.push_back({person.id, earlier->cause, false});
    return;
  }
  const RobotSweep& sweep = sweeps_[id];
  const bool jumped_onto = robot.jumped && overlaps(sweep, person.start, person.radius);
  const double radius = person.radius - (contact_ == Contact::GHOST ? CONTACT_OVERLAP : 0.0);
  present.push_back(
      {person.id, jumped_onto ? ContactCause::ROBOT : causeOf(sweep, person.start, person.way, radius), true});
}

void Robots::noteSolidContacts(const std::vector<Agent>& agents, const std::vector<SolidMotion::Disc>& discs,
                               const SolidMotion& moved) {
  if (robots_.empty()) return;
  std::uint32_t disc = 0;
  for (const Agent& agent : agents) {
    if (!agent.isPresent()) continue;
    const PersonMotion person{agent.id, agent.radius, discs[disc].position, discs[disc].way};
    for (const SolidMotion::Touch& touch : moved.touches()) {
      if (touch.disc == disc) noteContact(touch.robot - moved.firstRobot(), person);
    }
    for (RobotId id = 0; id < robots_.size(); ++id) {
      if (overlaps(sweeps_[id], person.start, person.radius - CONTACT_OVERLAP)) noteContact(id, person);
    }
    ++disc;
  }
}

void Robots::noteRecordedContacts(const std::vector<PersonMotion>& recorded, const SolidMotion& moved) {
  for (const PersonMotion& person : recorded) {
    for (const SolidMotion::Touch& touch : moved.touches()) {
      if (touch.disc == person.disc) noteContact(touch.robot - moved.firstRobot(), person);
    }
    const double radius = person.radius - CONTACT_OVERLAP;
    for (RobotId id = 0; id < robots_.size(); ++id) {
      // There are no impacts with a robot that stands after one, or that is EXTERNAL.
      const RobotSweep& sweep = moved.sweeps()[id];
      const double from = robots_[id].start.drive == Drive::EXTERNAL ? 0.0 : sweep.stoppedAt();
      const Vector2 place = person.start + from * person.way;
      const bool is_passed = from < 1.0 && firstTouch(sweep, place, person.way, radius, from) < NO_IMPACT;
      if (is_passed || overlaps(sweeps_[id], person.start, radius)) noteContact(id, person);
    }
  }
}

void Robots::noteGhostContacts(const Span<Agent>& agents, double time) {
  for (RobotId id = 0; id < robots_.size(); ++id) {
    for (const Agent& agent : agents) {
      if (!agent.isPresent()) continue;
      const Vector2 way = time * agent.velocity;
      noteGhostContact(id, {agent.id, agent.radius, agent.pose.position - way, way});
    }
  }
}

void Robots::noteGhostContacts(const std::vector<PersonMotion>& people) {
  for (RobotId id = 0; id < robots_.size(); ++id) {
    for (const PersonMotion& person : people) noteGhostContact(id, person);
  }
}

void Robots::noteGhostContact(RobotId id, const PersonMotion& person) {
  const RobotSweep& sweep = sweeps_[id];
  const double radius = person.radius - CONTACT_OVERLAP;
  const bool touches =
      overlaps(sweep, person.start, radius) || firstTouch(sweep, person.start, person.way, radius, 0.0) < NO_IMPACT;
  if (touches) noteContact(id, person);
}

void Robots::endMoves() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = robots_[i];
    robot.contacts.swap(contacts_[i]);
    contacts_[i].clear();
    if (robot.start.drive == Drive::EXTERNAL) {
      robot.twist = {Rotation(robot.pose.heading).intoFrame(robot.velocity), 0.0};
    } else {
      const RobotSweep& sweep = sweeps_[i];
      robot.pose = sweep.at(1.0);
      robot.pose.heading = wrapAngle(robot.pose.heading);
      const bool has_met = sweep.stoppedAt() < 1.0 || sweep.hasSlid();
      robot.blocked = has_met && !(robot.twist.linear.isZero(0.0) && robot.twist.rotation == 0.0);
      if (sweep.stoppedAt() < 1.0) {
        stopAtImpact(robot, (1.0 - sweep.stoppedAt()) * tick_duration_);
      } else if (sweep.hasSlid()) {
        const BodyMotion motion = sweep.motionAt(1.0);
        robot.twist = {Rotation(robot.pose.heading).intoFrame(motion.velocity), motion.rotation};
      }
      robot.velocity = Rotation(robot.pose.heading).outOfFrame(robot.twist.linear);
    }
    robot.waited = robot.waits() ? robot.waited + tick_duration_ : 0.0;
    if (!robot.hasGoal() || robot.hasArrived()) continue;
    if ((robot.goal() - robot.pose.position).norm() > robot.start.goal_tolerance) continue;
    if (robot.next_goal + 1 < robot.goals.size()) {
      ++robot.next_goal;
    } else {
      robot.status = RobotStatus::ARRIVED;
    }
  }
}

}  // namespace crowd
