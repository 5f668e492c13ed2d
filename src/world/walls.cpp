#include "world/walls.h"

#include <algorithm>
#include <string>
#include <utility>

#include "social_crowd/errors.h"

namespace crowd {
namespace {

constexpr double USUAL_REACH = 0.9;  // of searches: radius 0.3 m and wall_distance 0.6 m; only speed depends on it [m]

}  // namespace

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

void Walls::use(std::vector<Segment> walls) { index_ = WallIndex(std::move(walls), USUAL_REACH); }

}  // namespace crowd
