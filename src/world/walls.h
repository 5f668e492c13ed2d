#pragma once

#include <cstddef>
#include <vector>

#include "geometry/wall_index.h"

namespace crowd {

/// @brief The walls of a world. Each has an id that is not used again; those of a scene have the ids 0, 1, 2 ...
class Walls {
 public:
  /// @brief The walls, by ascending id.
  const std::vector<Segment>& list() const { return index_.walls(); }
  const WallIndex& index() const { return index_; }
  /// @brief The id of each wall, in the order of list().
  const std::vector<std::size_t>& ids() const { return ids_; }

  /// @brief Adds a wall and returns its id.
  std::size_t add(const Segment& wall);
  /// @brief Removes a wall. @throws InputError if there is none of this id
  void remove(std::size_t id);
  void replaceAll(std::vector<Segment> walls);

 private:
  void use(std::vector<Segment> walls);

  WallIndex index_;
  std::vector<std::size_t> ids_;
  std::size_t next_id_ = 0;
};

}  // namespace crowd
