#include "population/queue.h"

#include <algorithm>
#include <cmath>

namespace crowd {
namespace {

void erase(AgentId agent, std::vector<AgentId>& agents) {
  agents.erase(std::remove(agents.begin(), agents.end(), agent), agents.end());
}

void send(AgentId agent, const Vector2& place, World& world) {
  if (world.agents()[agent].goal() != place) world.walkingAgent(agent).setGoal(place);
}

}  // namespace

Vector2 Queue::end() const { return queue_->place(std::min(line_.size(), places_ - 1)); }

void Queue::leave(AgentId agent) {
  if (!line_.empty() && line_.front() == agent) service_end_.reset();
  erase(agent, line_);
  erase(agent, coming_);
}

bool Queue::stands(AgentId id, const World& world) const {
  const Agent& agent = world.agents()[id];
  if (agent.at_goal) return true;
  const bool is_coming = std::find(coming_.begin(), coming_.end(), id) != coming_.end();
  if (!is_coming || line_.size() < places_) return false;
  // They take about as much room each as in line.
  const double reach = queue_->spacing * (1.0 + std::sqrt(static_cast<double>(coming_.size())));
  return (agent.pose.position - end()).norm() < reach;
}

void Queue::measure(const World& world) {
  if (layout_ == world.layoutChanges()) return;
  layout_ = world.layoutChanges();
  const double half = 0.5 * queue_->spacing;
  places_ = 1;
  while (places_ < MAX_PLACES &&
         world.walls().index().isClear(queue_->place(places_ - 1), queue_->place(places_), half)) {
    ++places_;
  }
}

void Queue::serve(const World& world, std::vector<AgentId>& served) {
  if (line_.empty()) return;
  const Agent& first = world.agents()[line_.front()];
  if (!service_end_) {
    if (!first.at_goal || first.goal() != queue_->head) return;
    service_end_ = world.time() + queue_->service.draw(random_) - TIME_ROUNDING;
  }
  if (world.time() < *service_end_) return;
  service_end_.reset();
  served.push_back(first.id);
  line_.erase(line_.begin());
}

/// The nearest agents stand in line first.
void Queue::admit(const World& world) {
  const auto distance = [&](AgentId agent) { return (world.agents()[agent].pose.position - end()).norm(); };
  const auto nearer = [&](AgentId one, AgentId other) { return distance(one) < distance(other); };
  while (!coming_.empty() && line_.size() < places_) {
    const auto nearest = std::min_element(coming_.begin(), coming_.end(), nearer);
    if (distance(*nearest) > queue_->spacing) return;
    line_.push_back(*nearest);
    coming_.erase(nearest);
  }
}

std::vector<AgentId> Queue::update(World& world) {
  std::vector<AgentId> served;
  measure(world);
  admit(world);
  serve(world, served);
  for (std::size_t i = 0; i < line_.size(); ++i) send(line_[i], queue_->place(i), world);
  for (const AgentId agent : coming_) send(agent, end(), world);
  return served;
}

}  // namespace crowd
