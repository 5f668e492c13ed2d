#include "population/followers.h"

#include <algorithm>
#include <array>

namespace crowd {
namespace {

constexpr double GOAL_GAP = 0.25;  // between the bodies of a leader and of followers at their goals [m]
// Of followers around the goal of their leader, from the direction in which it comes: first beside it [pi].
constexpr std::array<double, 7> PLACES = {0.5, -0.5, 0.75, -0.75, 1.0, 0.25, -0.25};
constexpr int RINGS = 3;
constexpr double ROBOT_GAP = 0.8;       // between a robot and those who follow it [m]
constexpr double ROBOT_DISTANCE = 0.3;  // by which the place behind it has moved before they get a new goal [m]

}  // namespace

Vector2 Followers::goalBeside(const Vector2& goal, const Vector2& from, std::size_t number, double radius,
                              const World& world) const {
  const double bearing = goal == from ? 0.0 : bearingOf(goal - from);
  const double step = 2.0 * radius + GOAL_GAP;
  for (int ring = 1; ring <= RINGS; ++ring) {
    for (const double angle : PLACES) {
      Vector2 place = goal + ring * step * unitVector(bearing + angle * PI);
      const bool fits = places_.fits(place, radius, world) && world.walls().index().isClear(goal, place, 0.0);
      if (fits && number-- == 0) return place;
    }
  }
  return goal;
}

std::vector<Vector2> Followers::goalsBeside(const std::vector<Vector2>& goals, Vector2 from, std::size_t number,
                                            double radius, const World& world) const {
  std::vector<Vector2> places;
  places.reserve(goals.size());
  for (const Vector2& goal : goals) {
    places.push_back(goalBeside(goal, from, number, radius, world));
    from = goal;
  }
  return places;
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
  if (leader.kind == Leader::Kind::AGENT) follower.leader_goals = world.agents()[leader.number].goals;
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

/// A follower has all goals at once, so that it need not wait for its leader at each of them, until those of the leader
/// change, as on a route and at an attraction: from then on it gets one after the other.
void Followers::followAgent(Follower& follower, World& world, RouteObserver& observer) const {
  const Agent& leader = world.agents()[follower.leader.number];
  Agent& agent = world.walkingAgent(follower.id);
  follower.goes_stepwise = follower.goes_stepwise || leader.goals != follower.leader_goals;
  agent.leaves = leader.leaves && (!follower.goes_stepwise || leader.next_goal + 1 >= leader.goals.size());
  if (leader.isHeldBy(Hold::ATTRACTION)) agent.leaves = false;
  const bool is_same_goal = follower.leader_goals == std::vector<Vector2>{leader.goal()};
  if (!follower.goes_stepwise || is_same_goal || leader.isHeldBy(Hold::ATTRACTION)) return;
  follower.leader_goals = {leader.goal()};
  agent.setGoals(goalsBeside({leader.goal()}, leader.pose.position, follower.number, agent.radius, world));
  observer.extendWay(agent);
}

void Followers::followRobot(Follower& follower, World& world, RouteObserver& observer) const {
  const Pose& pose = world.robots().require(follower.leader.number).pose;
  const std::vector<Vector2> present = {pose.position, unitVector(pose.heading)};
  if (present == follower.leader_goals) return;
  follower.leader_goals = present;
  const Agent& agent = world.agents()[follower.id];
  const Vector2 goal = goalBehind(follower.leader.number, follower.number, agent.radius, world);
  if ((goal - agent.goal()).norm() < ROBOT_DISTANCE) return;
  world.walkingAgent(follower.id).setGoal(goal);
  observer.recordGoal(world.agents()[follower.id], goal);
}

std::optional<Leader> Followers::leaderOf(AgentId id) const {
  const auto has_id = [id](const Follower& follower) { return follower.id == id; };
  const auto found = std::find_if(followers_.begin(), followers_.end(), has_id);
  return found == followers_.end() ? std::nullopt : std::optional<Leader>(found->leader);
}

void Followers::drop(AgentId id, World& world, RouteObserver& observer) {
  const auto has_id = [id](const Follower& follower) { return follower.id == id; };
  const auto found = std::find_if(followers_.begin(), followers_.end(), has_id);
  if (found == followers_.end()) return;
  release(*found, world, observer);
  followers_.erase(found);
}

}  // namespace crowd
