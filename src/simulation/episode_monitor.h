#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/thread_pool.h"
#include "population/route_observer.h"
#include "simulation/episode_result.h"

namespace crowd {

/// @brief Measures the motion of each agent tick by tick, with the metrics of the steering benchmark.
///
/// The owner calls observe() after each tick, and watch() and recordGoal() when it changes the world.
class EpisodeMonitor final : public RouteObserver {
 public:
  /// @brief What is known about the motion of one agent so far.
  struct Track {
    std::uint64_t begin = 0;  // tick at which it was added
    Vector2 start = Vector2::Zero();
    Vector2 goal = Vector2::Zero();  // of the next tick
    Vector2 position = Vector2::Zero();
    double course = 0.0;        // direction of the last step [rad]
    bool moves = false;         // whether `course` is valid
    double longest_step = 0.0;  // [m]
    double distance = 0.0;      // to the goal [m]
    double turn = 0.0;
    double max_speed = 0.0;
    AgentResult result;
  };

  EpisodeMonitor(const Scene& scene, const World& world);

  void watch(const AgentStart& start, const World& world) override;
  void recordGoal(const Agent& agent, const Vector2& goal) override;
  void extendWay(const Agent& agent) override;
  void addDetour(const Agent& agent, const Vector2& place) override;
  void countWaypoint(AgentId id) override { ++tracks_[id].result.waypoints; }
  void setEndless(AgentId id, bool endless) override { tracks_[id].result.endless = endless; }

  /// @brief Replaces the tracks by those of these agents, in their order. @return the former tracks
  std::vector<Track> replaceTracks(const AgentMap<Agent>& agents, const std::vector<Track>& tracks);
  const AgentMap<Track>& tracks() const { return tracks_; }
  /// @brief The result of one track.
  AgentResult resultOf(const Track& track) const;

  /// @brief Measures one tick; call it after each tick. Agents that do not perceive are left out. @param thread_pool
  /// its threads share the agents
  void observe(const World& world, ThreadPool& thread_pool = ThreadPool::callerOnly());
  EpisodeResult result() const;

 private:
  /// Minimum speed at which the direction of motion is evaluated [m/s].
  static constexpr double MOVING = 0.05;

  /// @param along_heading whether it moved in the direction of its heading
  void observeAgent(const Agent& agent, bool along_heading, Track& track) const;

  std::string scenario_;
  double tick_duration_;
  double goal_tolerance_;
  std::uint64_t ticks_ = 0;
  AgentMap<Track> tracks_;  // of the agents of the world
  std::size_t watched_count_ = 0;
  AgentResults left_;  // of all others
};

}  // namespace crowd
