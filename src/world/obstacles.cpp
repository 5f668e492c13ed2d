#include "world/obstacles.h"

#include <utility>

namespace crowd {

Obstacles::Obstacles(std::vector<Obstacle> obstacles, double time) : list_(std::move(obstacles)), time_(time) {
  for (const Obstacle& obstacle : list_) {
    if (obstacle.path.moves()) movers_.push_back({motions_.size(), ABSENT});
    motions_.push_back(obstacle.path.at(time));
  }
}

bool Obstacles::moveTo(double time) {
  time_ = time;
  bool have_changed = false;
  for (const Mover& mover : movers_) {
    motions_[mover.number] = list_[mover.number].path.at(time);
    have_changed = have_changed || isPresent(mover.number) == (mover.rank == ABSENT);
  }
  return have_changed;
}

void Obstacles::addTo(NeighbourGrid& grid, std::size_t first_body) {
  std::size_t rank = 0;
  auto mover = movers_.begin();
  for (std::size_t i = 0; i < list_.size(); ++i) {
    const bool is_present = isPresent(i);
    if (list_[i].path.moves()) (mover++)->rank = is_present ? rank : ABSENT;
    if (!is_present) continue;
    ++rank;
    grid.add(motions_[i].position, list_[i].radius, static_cast<std::uint32_t>(first_body + i), motions_[i].velocity);
  }
}

void Obstacles::moveIn(NeighbourGrid& grid, std::size_t first) const {
  for (const Mover& mover : movers_) {
    if (mover.rank == ABSENT) continue;
    const ObstaclePath::Motion& motion = motions_[mover.number];
    grid.move(first + mover.rank, motion.position, motion.velocity);
  }
}

void Obstacles::addDiscs(double end, bool move, std::vector<SolidMotion::Disc>& discs) const {
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (!isPresent(i)) continue;
    const Vector2 way = move ? Vector2(list_[i].path.position(end) - motions_[i].position) : Vector2::Zero();
    discs.push_back({motions_[i].position, way, list_[i].radius, false});
  }
}

std::vector<Neighbour> Obstacles::recordedPeople() const {
  std::vector<Neighbour> people;
  for (const Mover& mover : movers_) {
    const Obstacle& obstacle = list_[mover.number];
    const ObstaclePath::Motion& motion = motions_[mover.number];
    if (!obstacle.person || mover.rank == ABSENT) continue;
    people.push_back({motion.position, motion.velocity, obstacle.radius, NeighbourKind::OBSTACLE});
  }
  return people;
}

std::vector<PersonMotion> Obstacles::recordedMotions(double end) const {
  std::vector<PersonMotion> motions;
  for (const Mover& mover : movers_) {
    const Obstacle& obstacle = list_[mover.number];
    if (!obstacle.person || mover.rank == ABSENT) continue;
    PersonMotion& motion = motions.emplace_back();
    motion.id = idOfRecorded(mover.number);
    motion.radius = obstacle.radius;
    motion.start = motions_[mover.number].position;
    motion.way = obstacle.path.position(end) - motion.start;
    motion.disc = static_cast<std::uint32_t>(mover.rank);
  }
  return motions;
}

}  // namespace crowd
