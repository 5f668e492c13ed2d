#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "social_crowd/simulation/agent_results.h"
#include "social_crowd/simulation/robot_result.h"
#include "social_crowd/world/scene.h"
#include "social_crowd/world/world.h"

namespace crowd {

/// @brief "2 agents have goals out of reach". @param agents above 0
std::string outOfReachText(std::size_t agents);
/// @brief The same with the numbers of the first ten: "2 agents have goals out of reach (0, 7)".
/// @param agents at least one
std::string outOfReachText(const std::vector<AgentId>& agents);

/// @brief Results of an episode.
struct EpisodeResult {
  std::string scenario;
  std::uint64_t ticks = 0;
  AgentResults agents;
  std::vector<RobotResult> robots;
  std::string way_finding_problem;  ///< why way-finding was left out from some tick on; empty: it was not

  /// @brief Numbers of agents that were not removed; metrics are about these.
  struct Counts {
    std::size_t agents = 0;
    std::size_t arrived = 0;
    std::size_t expected = 0;  ///< to arrive: without agents on routes that repeat
    std::size_t touched = 0;
    std::size_t collided = 0;
    std::uint64_t blocked_moves = 0;  ///< sum of all of them
    /// @brief Whether all expected agents arrived, and none was in contact.
    bool isClean() const { return arrived == expected && touched == 0; }
  };
  Counts count() const;
  std::size_t agentCount() const { return count().agents; }
  std::size_t arrivedCount() const { return count().arrived; }
  std::size_t expectedCount() const { return count().expected; }
  std::size_t touchedCount() const { return count().touched; }
  std::size_t collidedCount() const { return count().collided; }
  std::uint64_t blockedMoves() const { return count().blocked_moves; }
  bool isClean() const { return count().isClean(); }
  /// @brief The agents that count and have goals out of reach, by ascending number.
  std::vector<AgentId> outOfReach() const;
  /// @brief Warning about the ways of this episode, such as "2 agents have goals out of reach (0, 7)"; empty if there
  /// is none.
  std::string wayWarning() const;
  /// @brief Headings of all agents at the end [rad], for keepHeadings() of the next episode.
  std::vector<double> headings() const;
};

/// @brief Measures the motion of each agent tick by tick, with the metrics of the steering benchmark.
///
/// The owner calls observe() after each tick, and watch() and recordGoal() when it changes the world.
class EpisodeMonitor {
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

  /// @brief Registers the agent that was added to the world last.
  void watch(const AgentStart& start, const World& world);
  /// @brief Records a new goal of an agent [m]; its straight length is then that from its start via its present
  /// position to that goal.
  void recordGoal(const Agent& agent, const Vector2& goal);

  /// @brief Adds the way from an agent's position to its goal, that of the next leg of its route, to its straight
  /// length.
  void extendWay(const Agent& agent);
  /// @brief Counts a waypoint that an agent leaves behind.
  void countWaypoint(AgentId id) { ++tracks_[id].result.waypoints; }
  /// @brief Whether the agent is on a route that repeats.
  void setEndless(AgentId id, bool endless) { tracks_[id].result.endless = endless; }

  /// @brief Replaces the tracks, as World::replaceAgents() does with the agents. @return the former tracks
  std::vector<Track> replaceTracks(std::vector<Track> tracks);
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

/// @brief Metrics over many episodes, as printed by the scorer of the steering benchmark.
class Metrics {
 public:
  void add(const EpisodeResult& result);

  std::uint64_t episodes() const { return episodes_; }
  /// @brief Share of the expected agents that arrived; 100 if all are on routes that repeat.
  double successPercent() const { return expected_ == 0 && agents_ > 0 ? 100.0 : percent(arrived_, expected_); }
  double contactPercent() const { return percent(touched_, agents_); }
  double collisionPercent() const { return percent(collided_, agents_); }
  double cleanPercent() const { return percent(clean_, episodes_); }
  /// @brief Mean over the agents that arrived; NaN if none did. The same holds for the next two.
  double pathRatio() const { return meanOf(path_ratio_, arrived_); }
  double timeRatio() const { return meanOf(time_ratio_, arrived_); }
  double turnPerMetre() const { return meanOf(turn_per_metre_, arrived_); }
  double maxSpeedRatio() const { return max_speed_ratio_; }
  /// @brief Mean number of blocked moves per agent; NaN without agents.
  double blockedMovesPerAgent() const { return meanOf(static_cast<double>(blocked_moves_), agents_); }

 private:
  static double percent(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  }
  static double meanOf(double sum, std::uint64_t count) {
    return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(count);
  }

  std::uint64_t episodes_ = 0;
  std::uint64_t clean_ = 0;
  std::uint64_t agents_ = 0;
  std::uint64_t expected_ = 0;
  std::uint64_t arrived_ = 0;
  std::uint64_t touched_ = 0;
  std::uint64_t collided_ = 0;
  std::uint64_t blocked_moves_ = 0;
  double path_ratio_ = 0.0;
  double time_ratio_ = 0.0;
  double turn_per_metre_ = 0.0;
  double max_speed_ratio_ = 0.0;
};

}  // namespace crowd
