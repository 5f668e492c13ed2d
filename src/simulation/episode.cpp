#include "social_crowd/simulation/episode.h"

namespace crowd {

Episode::Episode(Scene scene, std::uint64_t number, const Vision& vision, Workers& workers)
    : scene_(std::move(scene)),
      world_(scene_),
      vision_(vision),
      workers_(&workers),
      monitor_(scene_, world_),
      number_(number) {
  perceive();
}

void Episode::step(const std::vector<AgentAction>& actions) {
  world_.step(actions, *workers_);
  monitor_.observe(world_, *workers_);
  perceive();
}

void Episode::perceive() {
  perceptions_.reset();
  perceptions_ = buffers_.next();
  world_.perceive(vision_, *perceptions_, *workers_);
  perceptions_->episode = number_;
  perceptions_->last = world_.activeCount() == 0 || world_.tick() >= scene_.max_ticks;
}

AgentId Episode::spawnAgent(const AgentStart& start) {
  const AgentId id = world_.spawnAgent(start);
  monitor_.watch(start, world_);
  perceive();
  return id;
}

void Episode::removeAgent(AgentId id) {
  world_.removeAgent(id);
  perceive();
}

void Episode::setGoal(AgentId id, const Vector2& goal) {
  world_.setGoal(id, goal);
  monitor_.noteGoal(world_.agents()[id], goal);
  perceive();
}

std::size_t Episode::spawnObstacle(const Vector2& position, const Vector2& velocity, double radius) {
  const std::size_t number = world_.spawnObstacle(position, velocity, radius);
  perceive();
  return number;
}

void Episode::removeObstacle(std::size_t number) {
  world_.removeObstacle(number);
  perceive();
}

}  // namespace crowd
