#include "ros/messages/perception_limiter.h"

#include "ros/messages/vision.h"

namespace crowd {

const Perceptions& PerceptionLimiter::limit(const Perceptions& perceptions, const Vision& made_with) {
  if (areEqual(made_with, vision_)) return perceptions;
  limited_.episode = perceptions.episode;
  limited_.tick = perceptions.tick;
  limited_.turn = perceptions.turn;
  limited_.tick_duration = perceptions.tick_duration;
  limited_.motion = perceptions.motion;
  limited_.last = perceptions.last;
  limited_.agents = perceptions.agents;
  limited_.neighbours.clear();
  limited_.walls.clear();
  for (std::size_t i = 0; i < perceptions.agents.size(); ++i) {
    const Perception wide(perceptions, i);
    AgentPerception& self = limited_.agents[i];
    self.first_neighbour = static_cast<std::uint32_t>(limited_.neighbours.size());
    self.first_wall = static_cast<std::uint32_t>(limited_.walls.size());
    neighbours_.assign(wide.neighbours.begin(), wide.neighbours.end());
    neighbours_.resize(Vision{vision_.radius}.countOf(neighbours_));
    limitWalls(wide);
    if (vision_.occlusion && !made_with.occlusion) {
      occlusion_.apply(neighbours_, 0, limited_.walls, self.first_wall, vision_.radius);
    }
    neighbours_.resize(vision_.countOf(neighbours_));
    for (const Neighbour& neighbour : neighbours_) limited_.neighbours.push_back(neighbour);
    self.neighbour_count = static_cast<std::uint32_t>(neighbours_.size());
    self.wall_count = static_cast<std::uint32_t>(limited_.walls.size()) - self.first_wall;
  }
  return limited_;
}

void PerceptionLimiter::limitWalls(const Perception& wide) {
  const double reach = vision_.wallReach(wide.self.radius, wide.motion.reach(wide.self.max_speed, wide.tick_duration));
  for (const Segment& wall : wide.walls) {
    if (distanceTo(wall, Vector2::Zero()) <= reach) limited_.walls.push_back(wall);
  }
}

}  // namespace crowd
