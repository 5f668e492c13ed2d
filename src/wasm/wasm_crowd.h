#pragma once

#include <emscripten/val.h>

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/episode.h"
#include "social_crowd/episode.h"
#include "world/world.h"

namespace crowd::wasm {

using emscripten::val;

/// @brief A crowd that walks tick by tick, for JavaScript. Numbers, points [x, y] and objects are those of the page's
/// protocol; functions that change the world throw InputError as those of library::Episode do.
class WasmCrowd {
 public:
  /// @param scenario, table names or files @param seed, number as for library::Episode
  WasmCrowd(const std::string& scenario, const std::string& table, double seed, double number);

  /// @brief Walks a tick. @return false if the episode is over: nothing has moved
  bool step();
  bool isOver() { return episode_.isOver(); }
  double tick() { return static_cast<double>(episode_.tick()); }
  double time() { return episode_.time(); }
  double tickDuration() { return episode_.tickDuration(); }
  /// @brief Number of agents that have arrived so far.
  double arrived();

  /// @brief Typed arrays of all agents by field, such as `x`, `goal` with two numbers for each. They show the memory of
  /// the module: valid until the next call of any function.
  val agents();
  val walls();
  val obstacles();
  /// @brief The robots with their scans.
  val robots();
  /// @brief The map of the scene with its cells as Uint8Array, or null.
  val map();
  /// @brief What an agent chooses from now, or null if it does not decide. The Q-table does not change.
  val mind(AgentId agent);

  AgentId addAgent(const val& position, const val& goal, double heading, double max_speed, double radius);
  void removeAgent(AgentId agent) { episode_.removeAgent(agent); }
  void setGoal(AgentId agent, const val& goal);
  double addObstacle(const val& position, double radius);
  void removeObstacle(double number) { episode_.episode().edit().removeObstacle(static_cast<std::size_t>(number)); }
  double addWall(const val& from, const val& to);
  void removeWall(double id) { episode_.removeWall(static_cast<std::size_t>(id)); }

 private:
  WasmCrowd(const library::Scenario& scenario, const library::QTable& table, std::uint64_t seed, std::uint64_t number);
  const World& world() { return episode_.episode().world(); }
  val scanOf(std::uint32_t robot);

  library::Learner learner_;
  library::Episode episode_;
  library::AgentArrays arrays_;
  std::vector<std::uint8_t> cells_;
};

}  // namespace crowd::wasm
