#include "social_crowd/ros/controller/perception_limiter.h"

#include "social_crowd/ros/messages/vision.h"

namespace crowd {

const Perceptions& PerceptionLimiter::limit(const Perceptions& perceptions, const Vision& made_with) {
  if (areEqual(made_with, vision_)) return perceptions;
  limited_.episode = perceptions.episode;
  limited_.tick = perceptions.tick;
  limited_.turn = perceptions.turn;
  limited_.tick_duration = perceptions.tick_duration;
  limited_.last = perceptions.last;
  limited_.agents = perceptions.agents;
  limited_.neighbours.clear();
  limited_.walls.clear();
  for (std::size_t i = 0; i < perceptions.agents.size(); ++i) {
    const Perception wide(perceptions, i);
    AgentPerception& self = limited_.agents[i];
    self.first_neighbour = static_cast<std::uint32_t>(limited_.neighbours.size());
    self.first_wall = static_cast<std::uint32_t>(limited_.walls.size());
    limitNeighbours(wide);
    limitWalls(wide);
    if (vision_.occlusion && !made_with.occlusion) {
      occlusion_.apply(neighbours_, 0, limited_.walls, self.first_wall, vision_.radius);
    }
    const bool too_many = vision_.max_neighbours > 0 && neighbours_.size() > vision_.max_neighbours;
    if (too_many) neighbours_.resize(vision_.max_neighbours);
    for (const Neighbour& neighbour : neighbours_) limited_.neighbours.push_back(neighbour);
    self.neighbour_count = static_cast<std::uint32_t>(neighbours_.size());
    self.wall_count = static_cast<std::uint32_t>(limited_.walls.size()) - self.first_wall;
  }
  return limited_;
}

void PerceptionLimiter::limitNeighbours(const Perception& wide) {
  neighbours_.clear();
  for (const Neighbour& neighbour : wide.neighbours) {
    if (rimDistance(neighbour) > vision_.radius) return;  // they are sorted, nearest rim first
    neighbours_.push_back(neighbour);
  }
}

void PerceptionLimiter::limitWalls(const Perception& wide) {
  for (const Segment& wall : wide.walls) {
    if (distanceTo(wall, Vector2::Zero()) <= vision_.radius) limited_.walls.push_back(wall);
  }
}

}  // namespace crowd
