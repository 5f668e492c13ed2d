#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <vector>

#include "common/files/scratch_file.h"
#include "world/agent_map.h"

namespace crowd {

/// @brief Results of one agent in an episode. A new field also belongs in one of the functions below.
struct AgentResult {
  bool arrived = false;
  bool removed = false;             ///< was removed on its way; excluded from all metrics
  bool touched = false;             ///< in contact in any tick before it arrived
  bool collided = false;            ///< in collision in any tick before it arrived (thesis, 4.1), see World
  bool out_of_reach = false;        ///< on its way at the end, and no way leads to its goal (WayFinder::isOutOfReach())
  bool endless = false;             ///< on a route that repeats: it never arrives, and has not failed
  std::uint64_t waypoints = 0;      ///< waypoints of routes that it has left behind
  std::uint64_t blocked_moves = 0;  ///< moves that were cut short by an impact; solid worlds only
  std::uint64_t appeared = 0;       ///< tick at which it was added to the world
  Vector2 start = Vector2::Zero();  ///< place where it was added [m], `map`
  std::uint64_t ticks = 0;          ///< from then on until its arrival, or until the end
  double heading = 0.0;             ///< at its arrival, or at the end [rad], `map`
  double path_length = 0.0;         ///< [m]
  double straight_length = 0.0;     ///< from the start via all goals, minus the goal tolerance [m]
  double path_ratio = 0.0;          ///< path_length / straight_length
  double time_ratio = 0.0;          ///< time * maximum speed / straight_length
  double turn_per_metre = 0.0;      ///< accumulated absolute change of direction of motion / path_length [rad/m]
  double max_speed_ratio = 0.0;     ///< highest speed in a tick / maximum speed
  double distance_gained = 0.0;     ///< decrease of the distance to the goal, summed over its goals [m]
  double gain_per_tick = 0.0;       ///< distance gained per step (thesis): distance_gained / ticks [m]
  double path_per_gain = 0.0;       ///< path_length / distance_gained; NaN if distance_gained is not positive

  /// @brief Calls visit(name, field...) for each field that records and AgentResult.msg have; with several objects,
  /// such as a result and its message, for the field of all.
  template <typename Visit, typename... Results>
  static void visitMeasures(const Visit& visit, Results&... results) {
    visit("arrived", results.arrived...);
    visit("touched", results.touched...);
    visit("collided", results.collided...);
    visit("blocked_moves", results.blocked_moves...);
    visit("ticks", results.ticks...);
    visit("path_length", results.path_length...);
    visit("path_ratio", results.path_ratio...);
    visit("time_ratio", results.time_ratio...);
    visit("turn_per_metre", results.turn_per_metre...);
  }

  /// @brief The same for each field of a record of agents.
  template <typename Visit, typename AResult>
  static void visitRecord(const Visit& visit, AResult& result) {
    visitMeasures(visit, result);
    visit("distance_gained", result.distance_gained);
    visit("gain_per_tick", result.gain_per_tick);
    visit("path_per_gain", result.path_per_gain);
  }

  /// @brief The same for all fields.
  template <typename Visit, typename AResult>
  static void visitFields(const Visit& visit, AResult& result) {
    visitRecord(visit, result);
    visit("removed", result.removed);
    visit("out_of_reach", result.out_of_reach);
    visit("endless", result.endless);
    visit("waypoints", result.waypoints);
    visit("appeared", result.appeared);
    visit("start", result.start);
    visit("heading", result.heading);
    visit("straight_length", result.straight_length);
    visit("max_speed_ratio", result.max_speed_ratio);
  }
};

/// @brief Results of the agents 0, 1, 2 ... of an episode. Those of many agents that have left are in a temporary file,
/// so that a long episode takes no more memory than a short one; they are read when they are asked for.
///
/// Copies share the file: only the one that calls storeIfMany() may add further agents.
class AgentResults {
 public:
  AgentResults() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a list is one
  AgentResults(std::vector<AgentResult> results) : held_(std::move(results)), size_(held_.size()) {}
  AgentResults(std::initializer_list<AgentResult> results) : AgentResults(std::vector<AgentResult>(results)) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  /// @throws FileError if the temporary file cannot be read
  AgentResult operator[](std::size_t agent) const;
  /// @throws std::out_of_range also if there is no such agent
  AgentResult at(std::size_t agent) const;

  /// @brief Iterates over copies.
  class Iterator {
   public:
    // NOLINTBEGIN(readability-identifier-naming): names of the standard library
    using iterator_category = std::input_iterator_tag;
    using value_type = AgentResult;
    using difference_type = std::ptrdiff_t;
    using pointer = const AgentResult*;
    using reference = AgentResult;
    // NOLINTEND(readability-identifier-naming)

    Iterator(const AgentResults& results, std::size_t agent) : results_(&results), agent_(agent) {}
    AgentResult operator*() const { return (*results_)[agent_]; }
    Iterator& operator++() {
      ++agent_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return agent_ != other.agent_; }

   private:
    const AgentResults* results_;
    std::size_t agent_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size_}; }

  /// @brief The result of an agent that has not left, which is added if it is not there.
  AgentResult& add(AgentId agent);
  /// @brief Moves all results to the file if there are many. @throws FileError
  void storeIfMany();

 private:
  static constexpr std::size_t MANY = 1024;

  AgentMap<AgentResult> held_;
  std::shared_ptr<ScratchFile> file_;  // of all others, by agent
  std::size_t size_ = 0;
};

}  // namespace crowd
