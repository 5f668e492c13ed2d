// Contacts of robots, and places that they occupy.

#include <algorithm>

#include "social_crowd/common/quotes.h"
#include "social_crowd/geometry/impact.h"
#include "social_crowd/world/world.h"

namespace crowd {
namespace {

/// The cause of a contact if robot and agent move as they intend: a side moves in if its motion alone touches the other
/// side at the place of the start of the tick. @param start of the agent [m] @param way of the agent in the tick [m]
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

void World::noteGhostContacts(const Agent& agent, const Vector2& way) {
  if (!agent.isWalking()) return;
  const Vector2 start = agent.pose.position - way;
  const double radius = agent.radius - CONTACT_OVERLAP;
  for (RobotId id = 0; id < robots_.size(); ++id) {
    const RobotSweep& sweep = robot_sweeps_[id];
    if (overlaps(sweep, start, radius) || firstTouch(sweep, start, way, radius, 0.0) < NO_IMPACT) {
      noteRobotContact(id, agent, start, way);
    }
  }
}

void World::noteRobotContact(RobotId id, const Agent& agent, const Vector2& start, const Vector2& way) {
  const auto is_with = [&](const RobotContact& contact) { return contact.agent == agent.id; };
  std::vector<RobotContact>& present = robot_contacts_[id];
  if (std::any_of(present.begin(), present.end(), is_with)) return;
  const Robot& robot = robots_[id];
  const auto earlier = std::find_if(robot.contacts.begin(), robot.contacts.end(), is_with);
  if (earlier != robot.contacts.end()) {
    present.push_back({agent.id, earlier->cause, false});
    return;
  }
  const RobotSweep& sweep = robot_sweeps_[id];
  const bool jumped_onto = robot.jumped && overlaps(sweep, start, agent.radius);
  const double radius = agent.radius - (contact_ == Contact::GHOST ? CONTACT_OVERLAP : 0.0);
  present.push_back({agent.id, jumped_onto ? ContactCause::ROBOT : causeOf(sweep, start, way, radius), true});
}

void World::noteSolidContacts() {
  std::uint32_t disc = 0;
  for (const Agent& agent : agents_) {
    if (!agent.isWalking()) continue;
    const SolidMotion::Disc& intended = discs_[disc];
    const auto first_robot = static_cast<std::uint32_t>(discs_.size() - robots_.size());
    for (const SolidMotion::Touch& touch : solid_motion_.touches()) {
      if (touch.disc == disc) noteRobotContact(touch.robot - first_robot, agent, intended.position, intended.way);
    }
    for (RobotId id = 0; id < robots_.size(); ++id) {
      if (!overlaps(robot_sweeps_[id], intended.position, agent.radius - CONTACT_OVERLAP)) continue;
      noteRobotContact(id, agent, intended.position, intended.way);
    }
    ++disc;
  }
}

bool World::isRobotWithin(double distance, const Vector2& place) const {
  return std::any_of(robots_.begin(), robots_.end(), [&](const Robot& robot) {
    return crowd::distance(robot.start.footprint, robot.pose, place) < distance;
  });
}

std::string World::findRobotBlocker(const Vector2& centre, double radius, std::optional<RobotId> except) const {
  for (RobotId id = 0; id < robots_.size(); ++id) {
    const Robot& robot = robots_[id];
    if (id == except || distance(robot.start.footprint, robot.pose, centre) >= radius) continue;
    return "robot " + inQuotes(robot.start.name);
  }
  return "";
}

}  // namespace crowd
