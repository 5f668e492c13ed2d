#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "social_crowd/world/scene.h"
#include "social_crowd/world/world.h"

namespace crowd {

/// @brief How one agent fared in an episode.
struct AgentResult {
  bool arrived = false;
  bool removed = false;             ///< was taken off the floor on the way; counts in no metric
  bool touched = false;             ///< in contact in any tick before it arrived
  bool collided = false;            ///< in collision in any tick before it arrived (thesis, 4.1), see World
  std::uint64_t blocked_moves = 0;  ///< moves that were cut short where it touched something; solid worlds only
  std::uint64_t ticks = 0;          ///< until it arrived, or until the end
  double heading = 0.0;             ///< at the end, or when it arrived [rad], `map`
  double path_length = 0.0;         ///< [m]
  double straight_length = 0.0;     ///< start to goal (to goal ...) less the goal tolerance [m]
  double path_ratio = 0.0;          ///< path_length / straight_length
  double time_ratio = 0.0;          ///< time * maximum speed / straight_length
  double turn_per_metre = 0.0;      ///< summed change of direction of motion per metre walked [rad/m]
  double max_speed_ratio = 0.0;     ///< fastest tick / maximum speed
  double distance_gained = 0.0;     ///< by how much it came nearer to its goal, all goals it walked to summed up [m]
  double gain_per_tick = 0.0;       ///< the thesis's distance gained per step: distance_gained / ticks [m]
  double path_per_gain = 0.0;       ///< path_length / distance_gained; not a number if nothing was gained
};

/// @brief How an episode went.
struct EpisodeResult {
  std::string scenario;
  std::uint64_t ticks = 0;
  std::vector<AgentResult> agents;

  /// @brief Agents that count: all that were not removed.
  std::size_t agentCount() const;
  std::size_t arrivedCount() const;
  std::size_t touchedCount() const;
  std::size_t collidedCount() const;
  /// @brief The headings of all agents at the end, for keepHeadings() of the next episode.
  std::vector<double> headings() const;
  /// @brief Blocked moves of all agents that count.
  std::uint64_t blockedMoves() const;
  /// @brief Everybody arrived, nobody was in contact.
  bool isClean() const { return arrivedCount() == agentCount() && touchedCount() == 0; }
};

/// @brief Watches a world tick by tick and measures what each agent does, as the steering benchmark defines it.
class EpisodeMonitor {
 public:
  EpisodeMonitor(const Scene& scene, const World& world);

  /// @brief Takes in the agent that was put into the world last.
  void watch(const AgentStart& start, const World& world);
  /// @brief Takes note that an agent has another goal [m]; its straight way goes on to that from where it is.
  void recordGoal(const Agent& agent, const Vector2& goal);

  /// @brief To be called after every step. @param thread_pool its threads share out the agents
  void observe(const World& world, ThreadPool& thread_pool = ThreadPool::callerOnly());
  EpisodeResult result() const;

 private:
  /// Direction of motion counts above this speed only [m/s].
  static constexpr double MOVING = 0.05;

  struct Track {
    std::uint64_t begin = 0;  // tick at which it came
    Vector2 start = Vector2::Zero();
    Vector2 goal = Vector2::Zero();  // that it walks to in the next tick
    Vector2 position = Vector2::Zero();
    double course = 0.0;        // direction of the last step [rad]
    bool moves = false;         // and whether it counts
    double longest_step = 0.0;  // [m]
    double distance = 0.0;      // from the goal
    double turn = 0.0;
    double max_speed = 0.0;
    AgentResult result;
  };
  /// @param along_heading whether it moved the way it looks
  void observeAgent(const Agent& agent, bool along_heading, Track& track) const;

  std::string scenario_;
  double tick_duration_;
  double goal_tolerance_;
  std::uint64_t ticks_ = 0;
  std::vector<Track> tracks_;
};

/// @brief Metrics over many episodes, as the steering benchmark's scorer prints them.
class Metrics {
 public:
  void add(const EpisodeResult& result);

  std::uint64_t episodes() const { return episodes_; }
  double successPercent() const { return percent(arrived_, agents_); }
  double contactPercent() const { return percent(touched_, agents_); }
  double collisionPercent() const { return percent(collided_, agents_); }
  double cleanPercent() const { return percent(clean_, episodes_); }
  /// @brief Means over the agents that arrived; not a number if none did.
  double pathRatio() const { return meanOf(path_ratio_, arrived_); }
  double timeRatio() const { return meanOf(time_ratio_, arrived_); }
  double turnPerMetre() const { return meanOf(turn_per_metre_, arrived_); }
  double maxSpeedRatio() const { return max_speed_ratio_; }
  /// @brief Mean number of blocked moves of an agent; not a number if there was none.
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
