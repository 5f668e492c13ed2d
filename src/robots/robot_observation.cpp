#include "robots/robot_observation.h"

#include <algorithm>

namespace crowd {
namespace {

void addOnce(AgentId agent, std::vector<AgentId>& agents) {
  if (std::find(agents.begin(), agents.end(), agent) == agents.end()) agents.push_back(agent);
}

double clearanceOf(const Robot& robot, const World& world) {
  double clearance = std::numeric_limits<double>::infinity();
  for (const Agent& agent : world.agents()) {
    if (!agent.isPresent()) continue;
    const double apart = distance(robot.start.footprint, robot.pose, agent.pose.position);
    clearance = std::min(clearance, apart - agent.radius);
  }
  for (const Neighbour& person : world.recordedPeople()) {
    const double apart = distance(robot.start.footprint, robot.pose, person.position);
    clearance = std::min(clearance, apart - person.radius);
  }
  return clearance;
}

}  // namespace

void addContacts(const Robot& robot, std::vector<RobotContact>& contacts) {
  for (const RobotContact& contact : robot.contacts) {
    const auto is_same = [&](const RobotContact& other) {
      return other.agent == contact.agent && other.cause == contact.cause;
    };
    if (std::none_of(contacts.begin(), contacts.end(), is_same)) contacts.push_back(contact);
  }
}

RobotObservation observeRobot(const Robot& robot, const World& world, const std::vector<RobotContact>& contacts) {
  RobotObservation seen;
  seen.pose = robot.pose;
  seen.twist = robot.twist;
  seen.has_goal = robot.hasGoal();
  seen.arrived = robot.hasArrived();
  seen.blocked = robot.blocked;
  if (robot.hasGoal()) seen.goal = Rotation(robot.pose.heading).intoFrame(robot.goal() - robot.pose.position);
  seen.remaining_distance = robot.remainingDistance();
  for (const RobotContact& contact : contacts) {
    addOnce(contact.agent, seen.contacts);
    if (contact.cause == ContactCause::ROBOT) addOnce(contact.agent, seen.by_robot);
    if (contact.cause == ContactCause::PERSON) addOnce(contact.agent, seen.by_person);
  }
  seen.clearance = clearanceOf(robot, world);
  return seen;
}

std::vector<Neighbour> visiblePeople(const World& world, RobotId robot, RobotSenses& senses) {
  const std::vector<bool>& visible = senses.visibleBodies(world, robot);
  const Pose& pose = world.robots()[robot].pose;
  const Rotation frame(pose.heading);
  std::vector<Neighbour> people;
  const auto add = [&](const Vector2& position, const Vector2& velocity, double radius) {
    people.push_back(
        {frame.intoFrame(position - pose.position), frame.intoFrame(velocity), radius, NeighbourKind::AGENT});
  };
  for (std::size_t i = 0; i < world.agents().size(); ++i) {
    const Agent& agent = world.agents().nth(i);
    if (agent.isPresent() && visible[i]) add(agent.pose.position, agent.velocity, agent.radius);
  }
  for (std::size_t i = 0; i < world.obstacles().size(); ++i) {
    const Obstacle& obstacle = world.obstacles()[i];
    if (!obstacle.person || !world.isPresent(obstacle) || !visible[world.agents().size() + i]) continue;
    const PathMotion motion = obstacle.path.at(world.time());
    add(motion.position, motion.velocity, obstacle.radius);
  }
  std::stable_sort(people.begin(), people.end(),
                   [](const Neighbour& one, const Neighbour& other) { return rimDistance(one) < rimDistance(other); });
  return people;
}

}  // namespace crowd
