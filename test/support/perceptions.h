#pragma once

#include <cstdint>

#include "world/perception.h"

namespace crowd {

/// @brief The point at a bearing [degrees, counterclockwise from ahead] and a distance [m].
inline Vector2 polar(double degrees, double distance) { return distance * unitVector(toRadians(degrees)); }

/// @brief Makes perceptions for tests, agent by agent. Neighbours, walls and properties apply to the agent added last.
class PerceptionsBuilder {
 public:
  explicit PerceptionsBuilder(std::uint64_t episode = 0, std::uint64_t tick = 0) {
    all_.episode = episode;
    all_.tick = tick;
    all_.tick_duration = 0.1;
  }

  /// @brief An agent that has not arrived and whose last answer was carried out; goal in its own frame [m].
  PerceptionsBuilder& agent(AgentId id, const Vector2& goal) {
    AgentPerception self;
    self.agent = id;
    self.goal = goal;
    self.max_speed = 0.3;
    self.radius = 0.25;
    self.acted = true;
    self.first_neighbour = static_cast<std::uint32_t>(all_.neighbours.size());
    self.first_wall = static_cast<std::uint32_t>(all_.walls.size());
    all_.agents.push_back(self);
    return *this;
  }

  /// @brief Sets the maximum speed [m/s].
  PerceptionsBuilder& speed(double max_speed) {
    all_.agents.back().max_speed = max_speed;
    return *this;
  }

  /// @brief Sets the heading of the agent [degrees, `map`].
  PerceptionsBuilder& heading(double degrees) {
    all_.agents.back().pose.heading = toRadians(degrees);
    return *this;
  }

  /// @brief Velocity of the agent in the last tick, agent frame [m/s].
  PerceptionsBuilder& walking(const Vector2& velocity) {
    all_.agents.back().velocity = velocity;
    return *this;
  }

  /// @brief Sets the motion limits of all agents.
  PerceptionsBuilder& motion(const MotionLimits& motion) {
    all_.motion = motion;
    return *this;
  }

  PerceptionsBuilder& neighbour(const Vector2& position, double radius) {
    Neighbour neighbour;
    neighbour.position = position;
    neighbour.radius = radius;
    all_.neighbours.push_back(neighbour);
    ++all_.agents.back().neighbour_count;
    return *this;
  }

  /// @brief Sets the kind of the last neighbour.
  PerceptionsBuilder& kind(NeighbourKind kind) {
    Neighbour neighbour = all_.neighbours[all_.neighbours.size() - 1];
    neighbour.kind = kind;
    all_.neighbours.set(all_.neighbours.size() - 1, neighbour);
    return *this;
  }

  /// @brief Makes the last neighbour a robot that agents yield to. @param comfort [m] @param wanted agent frame [m/s]
  PerceptionsBuilder& robot(double comfort, const Vector2& wanted = Vector2::Zero()) {
    Neighbour neighbour = all_.neighbours[all_.neighbours.size() - 1];
    neighbour.kind = NeighbourKind::ROBOT;
    neighbour.intent = {comfort, wanted};
    all_.neighbours.set(all_.neighbours.size() - 1, neighbour);
    return *this;
  }

  /// @brief Velocities of the agent and of its last neighbour in the last tick, agent frame [m/s].
  PerceptionsBuilder& velocity(const Vector2& own, const Vector2& of_body) {
    all_.agents.back().velocity = own;
    Neighbour neighbour = all_.neighbours[all_.neighbours.size() - 1];
    neighbour.velocity = of_body;
    all_.neighbours.set(all_.neighbours.size() - 1, neighbour);
    return *this;
  }

  PerceptionsBuilder& wall(const Vector2& from, const Vector2& to) {
    all_.walls.push_back({from, to});
    ++all_.agents.back().wall_count;
    return *this;
  }

  /// @brief The agent has reached its last goal.
  PerceptionsBuilder& arrived() {
    all_.agents.back().arrived = true;
    return *this;
  }

  /// @brief The agent's last answer was not carried out.
  PerceptionsBuilder& missed() {
    all_.agents.back().acted = false;
    return *this;
  }

  /// @brief The episode ends here.
  PerceptionsBuilder& last() {
    all_.last = true;
    return *this;
  }

  const Perceptions& all() const { return all_; }
  /// @brief The perception of agent `index`, in the order of addition; valid as long as the builder is unchanged.
  Perception perception(std::size_t index = 0) const { return {all_, index}; }

 private:
  Perceptions all_;
};

/// @brief Adds an agent with many neighbours that overlap it and approach. Code that reads beyond the neighbours of the
/// agent before it in the list finds an immediate collision.
inline void addTouchedAgent(AgentId id, PerceptionsBuilder& scene) {
  scene.agent(id, {9.0, 0.0});
  for (std::size_t i = 0; i < NeighbourList::PADDING; ++i) {
    scene.neighbour({0.1, 0.0}, 0.25).velocity(Vector2::Zero(), {-10.0, 0.0});
  }
}

}  // namespace crowd
