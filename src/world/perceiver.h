#pragma once

#include <cstdint>
#include <vector>

#include "geometry/neighbour_search.h"
#include "world/occlusion.h"
#include "world/perception.h"
#include "world/viewers.h"

namespace crowd {

/// @brief Perceives a world: finds the neighbours and walls of each viewer, nearest first, removes what is hidden, and
/// writes them in the viewer's frame.
///
/// Use one object per thread; it keeps its workspace. Any number of threads may perceive a world while no thread
/// changes it.
class Perceiver {
 public:
  /// @brief Writes the perceptions of these viewers of the world. Sets all fields but `episode`, `turn` and `last`.
  void perceive(const World& world, const Vision& vision, const Viewers& viewers, Perceptions& perceptions);

 private:
  /// Writes the perception of an agent, whose body is `body`, with neighbours from `first` on.
  void perceiveOne(const World& world, const Vision& vision, const Viewers::Viewer& viewer, std::size_t first,
                   Perceptions& perceptions);
  /// Finds the nearest bodies: those of the grid, and robots; robot i has the number grid().size() + i.
  Span<NearDisc> findBodies(const World& world, const Vision& vision, const Viewers::Viewer& viewer);
  void findWalls(const World& world, const Vision& vision, const Agent& agent, std::vector<Segment>& walls);

  NeighbourSearch search_;
  Occlusion occlusion_;
  NeighbourList near_;                     // all neighbours of one agent, hidden ones included
  std::vector<Neighbour> visible_;         // of these
  std::vector<std::uint32_t> near_walls_;  // of one agent
  std::vector<NearDisc> near_discs_;       // of one agent: bodies of the grid and robots
};

}  // namespace crowd
