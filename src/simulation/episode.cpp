#include "social_crowd/simulation/episode.h"

namespace crowd {

Episode::Episode(Scene scene, std::uint64_t number, const Vision& vision, Workers& workers)
    : scene_(std::move(scene)),
      world_(scene_),
      vision_(vision),
      workers_(&workers),
      monitor_(scene_, world_),
      number_(number) {}

void Episode::step(const std::vector<AgentAction>& actions) {
  world_.step(actions, *workers_);
  monitor_.observe(world_, *workers_);
  are_current_ = false;
}

bool Episode::isOver() const { return world_.activeCount() == 0 || world_.tick() >= scene_.max_ticks; }

const std::shared_ptr<Perceptions>& Episode::perceive() {
  if (are_current_) return perceptions_;
  buffers_.renew(perceptions_);
  world_.perceive(vision_, *perceptions_);
  perceptions_->episode = number_;
  perceptions_->last = isOver();
  are_current_ = true;
  return perceptions_;
}

void Episode::decide(Learner& learner, RelativeActions& actions) {
  if (learner.mode() != Mode::DEMO) return learner.decide(perceptions(), actions);
  actions.episode = number_;
  actions.tick = world_.tick();
  actions.agents.clear();
  if (!isOver()) crowd_.decide(world_, vision_, learner, actions.agents, *workers_);
}

AgentId Episode::spawnAgent(const AgentStart& start) {
  const AgentId id = world_.spawnAgent(start);
  monitor_.watch(start, world_);
  are_current_ = false;
  return id;
}

void Episode::removeAgent(AgentId id) {
  world_.removeAgent(id);
  are_current_ = false;
}

void Episode::setGoal(AgentId id, const Vector2& goal) {
  world_.setGoal(id, goal);
  monitor_.noteGoal(world_.agents()[id], goal);
  are_current_ = false;
}

std::size_t Episode::spawnObstacle(const Vector2& position, const Vector2& velocity, double radius) {
  const std::size_t number = world_.spawnObstacle(position, velocity, radius);
  are_current_ = false;
  return number;
}

void Episode::removeObstacle(std::size_t number) {
  world_.removeObstacle(number);
  are_current_ = false;
}

}  // namespace crowd
