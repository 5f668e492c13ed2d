#include "population/followers.h"

#include <algorithm>

namespace crowd {
namespace {

constexpr double GOAL_GAP = 0.25;       // between the bodies of a leader and of followers at their goals [m]
constexpr double ROBOT_GAP = 0.8;       // between a robot and those who follow it [m]
constexpr double ROBOT_DISTANCE = 0.3;  // by which the place behind it has moved before they get a new goal [m]

}  // namespace

Vector2 Followers::goalBeside(const Vector2& goal, const Vector2& from, std::size_t number, double radius,
                              const World& world) const {
  const Vector2 offset = goal - from;
  const Vector2 forward = offset.norm() > 1e-9 ? Vector2(offset.normalized()) : Vector2(Vector2::UnitX());
  const Vector2 left(-forward.y(), forward.x());
  const double step = 2.0 * radius + GOAL_GAP;
  const double distance = step * static_cast<double>(number / 2 + 1);
  const double side = number % 2 == 0 ? 1.0 : -1.0;
  for (const double sign : {side, -side}) {
    const Vector2 place = goal + sign * distance * left;
    if (places_->fits(place, radius, world) && world.walls().index().isClear(goal, place, 0.0)) return place;
  }
  return goal;
}

Vector2 Followers::goalBehind(RobotId robot, std::size_t number, double radius, const World& world) const {
  const Robot& leader = world.robots().require(robot);
  const Vector2 ahead = unitVector(leader.pose.heading);
  const Vector2 place = leader.pose.position - (leader.start.footprint.reach() + radius + ROBOT_GAP) * ahead;
  return goalBeside(place, place - ahead, number, radius, world);
}

std::size_t Followers::countOf(const Leader& leader) const {
  return static_cast<std::size_t>(std::count_if(followers_.begin(), followers_.end(), [&](const Follower& follower) {
    return groupOf(follower.leader) == groupOf(leader);
  }));
}

void Followers::add(AgentId id, const Leader& leader, bool is_endless, const World& world, RouteObserver& observer) {
  Follower follower;
  follower.id = id;
  follower.leader = leader;
  follower.number = countOf(leader);
  if (leader.kind == Leader::Kind::AGENT) follower.leader_goal = world.agents()[leader.number].goal();
  followers_.push_back(follower);
  observer.setEndless(id, is_endless);
}

void Followers::update(World& world, RouteObserver& observer) {
  const auto is_done = [&](Follower& follower) {
    if (!world.isActive(follower.id)) return true;
    if (hasLeft(follower.leader, world)) {
      release(follower, world, observer);
      return true;
    }
    const bool is_agent = follower.leader.kind == Leader::Kind::AGENT;
    is_agent ? followAgent(follower, world, observer) : followRobot(follower, world, observer);
    return false;
  };
  followers_.erase(std::remove_if(followers_.begin(), followers_.end(), is_done), followers_.end());
}

bool Followers::hasLeft(const Leader& leader, const World& world) {
  if (leader.kind == Leader::Kind::AGENT) return !world.isActive(leader.number);
  return world.robots().require(leader.number).hasArrived();
}

/// It leaves the world at its last goal.
void Followers::release(const Follower& follower, World& world, RouteObserver& observer) {
  world.walkingAgent(follower.id).leaves = true;
  observer.setEndless(follower.id, false);
}

void Followers::followAgent(Follower& follower, World& world, RouteObserver& observer) const {
  const Agent& leader = world.agents()[follower.leader.number];
  if (leader.goal() == follower.leader_goal) return;
  follower.leader_goal = leader.goal();
  const double radius = world.agents()[follower.id].radius;
  const Vector2 goal = goalBeside(leader.goal(), leader.pose.position, follower.number, radius, world);
  world.walkingAgent(follower.id).setGoal(goal);
  observer.extendWay(world.agents()[follower.id]);
}

void Followers::followRobot(const Follower& follower, World& world, RouteObserver& observer) const {
  const Agent& agent = world.agents()[follower.id];
  const Vector2 goal = goalBehind(follower.leader.number, follower.number, agent.radius, world);
  if ((goal - agent.goal()).norm() < ROBOT_DISTANCE) return;
  world.walkingAgent(follower.id).setGoal(goal);
  observer.recordGoal(world.agents()[follower.id], goal);
}

void Followers::drop(AgentId id, World& world, RouteObserver& observer) {
  const auto has_id = [id](const Follower& follower) { return follower.id == id; };
  const auto found = std::find_if(followers_.begin(), followers_.end(), has_id);
  if (found == followers_.end()) return;
  release(*found, world, observer);
  world.walkingAgent(id).group = NO_GROUP;
  world.walkingAgent(id).setPace(Pace::GROUP, 1.0);
  followers_.erase(found);
}

}  // namespace crowd
