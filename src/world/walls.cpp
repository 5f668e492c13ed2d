#include "world/walls.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "social_crowd/errors.h"

namespace crowd {

std::size_t Walls::add(const Segment& wall) {
  std::vector<Segment> walls = list();
  walls.push_back(wall);
  use(std::move(walls));
  ids_.push_back(next_id_++);
  return ids_.back();
}

void Walls::remove(std::size_t id) {
  const auto found = std::lower_bound(ids_.begin(), ids_.end(), id);
  if (found == ids_.end() || *found != id) throw InputError("there is no wall " + std::to_string(id));
  std::vector<Segment> walls = list();
  walls.erase(walls.begin() + (found - ids_.begin()));
  use(std::move(walls));
  ids_.erase(found);
}

void Walls::replaceAll(std::vector<Segment> walls) {
  use(std::move(walls));
  ids_.resize(list().size());
  for (std::size_t& id : ids_) id = next_id_++;
}

void Walls::use(std::vector<Segment> walls) {
  const bool are_many = walls.size() > MANY;
  reach_ = are_many ? NEAR : std::numeric_limits<double>::infinity();
  index_ = WallIndex(std::move(walls), are_many ? NEAR : 0.0);
}

}  // namespace crowd
