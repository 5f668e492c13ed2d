#include "population/facing.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace crowd {
namespace {

constexpr double STANDING_TURN_RATE = PI;  // of a person who stands [rad/s]

/// The direction of a place from an agent [rad]; none if it is there.
std::optional<double> bearingFrom(const Agent& agent, const Vector2& place) {
  if (place == agent.pose.position) return std::nullopt;
  return bearingOf(place - agent.pose.position);
}

std::optional<double> headingFor(const FacingDescription& face, const Agent& agent, const World& world) {
  using Kind = FacingDescription::Kind;
  if (face.kind == Kind::DIRECTION) return wrapAngle(toRadians(face.direction));
  if (face.kind == Kind::POINT) return bearingFrom(agent, face.point);
  for (const Robot& robot : world.robots()) {
    if (robot.start.name == face.robot) return bearingFrom(agent, robot.pose.position);
  }
  return std::nullopt;
}

}  // namespace

void turnTowards(const FacingDescription& face, AgentId id, World& world) {
  Agent& agent = world.walkingAgent(id);
  if (!agent.isHeld() || agent.velocity != Vector2::Zero()) return;
  const std::optional<double> wanted = headingFor(face, agent, world);
  if (!wanted || *wanted == agent.pose.heading) return;
  const double most = std::min(STANDING_TURN_RATE, world.motion().turn_rate) * world.tickDuration();
  const double turn = wrapAngle(*wanted - agent.pose.heading);
  agent.setHeading(std::abs(turn) <= most ? *wanted : agent.pose.heading + std::copysign(most, turn));
}

void turnTowards(const Vector2& place, AgentId id, World& world) {
  FacingDescription face;
  face.kind = FacingDescription::Kind::POINT;
  face.point = place;
  turnTowards(face, id, world);
}

}  // namespace crowd
