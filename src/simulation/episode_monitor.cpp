#include "simulation/episode_monitor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace crowd {
namespace {

/// Minimum denominator of ratios to lengths; ratios to shorter lengths are meaningless [m].
constexpr double MIN_LENGTH = 0.1;

double straightLength(const AgentStart& start, double goal_tolerance) {
  double length = -goal_tolerance;
  Vector2 from = start.position;
  for (const Vector2& goal : start.goals) {
    length += (goal - from).norm();
    from = goal;
  }
  return std::max(MIN_LENGTH, length);
}

}  // namespace

EpisodeMonitor::EpisodeMonitor(const Scene& scene, const World& world)
    : scenario_(scene.name), tick_duration_(scene.tick_duration), goal_tolerance_(scene.goal_tolerance) {
  for (const AgentStart& start : scene.agents) watch(start, world);
}

void EpisodeMonitor::watch(const AgentStart& start, const World& world) {
  Track& track = tracks_.add(static_cast<AgentId>(watched_count_++));
  track.begin = world.tick();
  track.start = start.position;
  track.goal = start.goals.front();
  track.position = start.position;
  track.distance = (track.goal - track.position).norm();
  track.max_speed = start.max_speed;
  track.result.heading = start.heading;
  track.result.straight_length = straightLength(start, goal_tolerance_);
}

void EpisodeMonitor::recordGoal(const Agent& agent, const Vector2& goal) {
  Track& track = tracks_[agent.id];
  const double length = (agent.pose.position - track.start).norm() + (goal - agent.pose.position).norm();
  track.result.straight_length = std::max(MIN_LENGTH, length - goal_tolerance_);
  track.goal = goal;
  track.distance = (goal - track.position).norm();
}

void EpisodeMonitor::extendWay(const Agent& agent) {
  tracks_[agent.id].result.straight_length += (agent.goal() - agent.pose.position).norm();
}

void EpisodeMonitor::addDetour(const Agent& agent, const Vector2& place) {
  const Vector2& position = agent.pose.position;
  tracks_[agent.id].result.straight_length +=
      (place - position).norm() + (agent.goal() - place).norm() - (agent.goal() - position).norm();
}

void EpisodeMonitor::observe(const World& world, ThreadPool& thread_pool) {
  ticks_ = world.tick();
  tracks_.keepOnly(world.agents(), [this](AgentId id, const Track& track) { left_.add(id) = resultOf(track); });
  left_.storeIfMany();
  // In a ghost world agents always move in the direction of their heading.
  const bool along_heading = world.contact() == Contact::GHOST;
  const auto observe_some = [&](unsigned /*worker*/, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Agent& agent = world.agents().nth(i);
      if (!agent.perceives) continue;
      Track& track = tracks_.nth(i);
      track.result.removed = agent.status == AgentStatus::REMOVED;
      const bool just_arrived = agent.hasArrived() && agent.arrival_tick == ticks_;
      if (agent.isWalking() || just_arrived) observeAgent(agent, along_heading, track);
    }
  };
  thread_pool.run(tracks_.size(), observe_some, ThreadPool::FEW_SHORT_ITEMS);
}

inline void EpisodeMonitor::observeAgent(const Agent& agent, bool along_heading, Track& track) const {
  const Vector2 step = agent.pose.position - track.position;
  const double length = step.norm();
  const double course = along_heading ? agent.pose.heading : bearingOf(step);
  const bool moves = length > MOVING * tick_duration_;
  if (moves && track.moves) track.turn += std::abs(wrapAngle(course - track.course));
  const double distance = (track.goal - agent.pose.position).norm();
  track.result.distance_gained += track.distance - distance;
  const bool same_goal = agent.goal() == track.goal;
  track.goal = agent.goal();
  track.position = agent.pose.position;
  track.distance = same_goal ? distance : (track.goal - track.position).norm();
  track.course = course;
  track.moves = moves;
  track.longest_step = std::max(track.longest_step, length);
  track.result.path_length += length;
  track.result.ticks = ticks_ - track.begin;
  track.result.heading = agent.pose.heading;
  track.result.touched = agent.touched;
  track.result.collided = agent.collided;
  track.result.blocked_moves = agent.blocked_moves;
  track.result.arrived = agent.hasArrived();
}

std::vector<EpisodeMonitor::Track> EpisodeMonitor::replaceTracks(const AgentMap<Agent>& agents,
                                                                 const std::vector<Track>& tracks) {
  std::vector<Track> former = tracks_.replace({});
  for (std::size_t i = 0; i < tracks.size(); ++i) tracks_.add(agents.idAt(i)) = tracks[i];
  return former;
}

AgentResult EpisodeMonitor::resultOf(const Track& track) const {
  AgentResult agent = track.result;
  agent.appeared = track.begin;
  agent.start_x = track.start.x();
  agent.start_y = track.start.y();
  agent.path_ratio = agent.path_length / agent.straight_length;
  agent.time_ratio = static_cast<double>(agent.ticks) * tick_duration_ * track.max_speed / agent.straight_length;
  agent.max_speed_ratio = track.longest_step / (tick_duration_ * track.max_speed);
  agent.turn_per_metre = track.turn / std::max(MIN_LENGTH, agent.path_length);
  agent.gain_per_tick = agent.ticks > 0 ? agent.distance_gained / static_cast<double>(agent.ticks) : 0.0;
  agent.path_per_gain = agent.distance_gained > 0.0 ? agent.path_length / agent.distance_gained
                                                    : std::numeric_limits<double>::quiet_NaN();
  return agent;
}

EpisodeResult EpisodeMonitor::result() const {
  EpisodeResult result;
  result.scenario = scenario_;
  result.ticks = ticks_;
  result.agents = left_;
  for (std::size_t i = 0; i < tracks_.size(); ++i) result.agents.add(tracks_.idAt(i)) = resultOf(tracks_.nth(i));
  return result;
}

}  // namespace crowd
