#pragma once

#include <cstddef>
#include <vector>

#include "geometry/neighbour_grid.h"
#include "geometry/solid_motion.h"
#include "scenario/scene.h"
#include "world/neighbours.h"
#include "world/robots.h"

namespace crowd {

/// @brief The obstacles of a world, also recorded people, and where they are at the present time.
class Obstacles {
 public:
  /// @param time the present time [s]
  explicit Obstacles(std::vector<Obstacle> obstacles, double time = 0.0);

  /// @brief All obstacles, also recorded people who are not present now.
  const std::vector<Obstacle>& list() const { return list_; }
  /// @brief Whether an obstacle is in the world now: a recorded person is from its first to its last record.
  bool isPresent(std::size_t number) const { return list_[number].path.isPresent(time_); }

  /// @brief Moves them to where they are at a time [s]. @return whether some have appeared or are gone since addTo()
  bool moveTo(double time);
  /// @brief Appends those that are present to a grid. @param first_body number of obstacle 0 there
  void addTo(NeighbourGrid& grid, std::size_t first_body);
  /// @brief Moves them in the grid of the last addTo(). @param first index in it of the first one that is present
  void moveIn(NeighbourGrid& grid, std::size_t first) const;
  /// @brief Appends those that are present as solid bodies. @param end time of the end of the tick [s] @param move
  /// whether they move until then
  void addDiscs(double end, bool move, std::vector<SolidMotion::Disc>& discs) const;

  /// @brief The recorded people who are present, in `map`.
  std::vector<Neighbour> recordedPeople() const;
  /// @brief Their motions until a time [s]; `disc` counts the obstacles that are present.
  std::vector<PersonMotion> recordedMotions(double end) const;

 private:
  static constexpr std::size_t ABSENT = static_cast<std::size_t>(-1);

  struct Mover {
    std::size_t number = 0;
    std::size_t rank = ABSENT;  // among the obstacles in the grid
  };

  std::vector<Obstacle> list_;
  double time_;
  std::vector<ObstaclePath::Motion> motions_;  // at the present time
  std::vector<Mover> movers_;
};

}  // namespace crowd
