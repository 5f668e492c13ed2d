#include "avoidance/comfort.h"

#include <algorithm>
#include <cmath>

#include "avoidance/gap_sharing.h"

namespace crowd {
namespace {

constexpr double ROOM_SHARE = 0.8;   // of the room behind an agent
constexpr double BEHIND = -0.5;      // cosine of the least angle to the direction towards the robot
constexpr double INNER_SHARE = 0.6;  // of the comfort, to which an agent comes at most
constexpr double SIDLING = 0.3;      // of the maximum speed: towards a robot within its comfort, as on the way round it

/// The room to walls and obstacles on the side of an agent that is away from a robot, as far as it is less than a limit
/// [m]. Agents there can step back, too.
double roomBehind(const Perception& seen, const Vector2& towards, double limit) {
  const double radius = seen.self.radius;
  double room = limit;
  const auto consider = [&](const Vector2& place, double gap) {
    if (towards.dot(place) < BEHIND * place.norm()) room = std::min(room, gap);
  };
  for (const Neighbour& neighbour : seen.neighbours) {
    const double gap = rimDistance(neighbour) - radius;
    if (gap >= room) break;  // nearest rim first
    if (neighbour.kind == NeighbourKind::OBSTACLE) consider(neighbour.position, gap);
  }
  for (const Segment& wall : seen.walls) {
    const Vector2 nearest = nearestPoint(wall, Vector2::Zero());
    consider(nearest, nearest.norm() - radius);
  }
  return std::max(0.0, room);
}

/// The greatest speed at which an agent stops within a way [m/s].
double speedFor(double way, const Perception& seen) {
  if (way <= 0.0) return 0.0;
  const double tick = seen.tick_duration;
  if (!seen.motion.areOn()) return way / tick;
  const double lost = seen.motion.braking * tick;
  return std::sqrt(lost * lost + 2.0 * seen.motion.braking * way) - lost;
}

/// Limits the speed of each move of a block in a direction. @param share of the maximum speed
void cutSpeed(const Vector2& towards, double share, MoveBlock& moves) {
  const double nx = towards.x();
  const double ny = towards.y();
  for (std::size_t i = 0; i < MoveBlock::SIZE; ++i) {
    const double closing = nx * moves.x[i] + ny * moves.y[i];
    const bool too_fast = (closing > 1e-9) & (moves.fraction[i] * closing > share);
    moves.fraction[i] = too_fast ? share / closing : moves.fraction[i];
  }
}

}  // namespace

double keptComfort(const Perception& seen, const Neighbour& robot) {
  const double comfort = robot.intent.comfort;
  const double distance = robot.position.norm();
  if (comfort <= 0.0 || distance <= 0.0) return 0.0;
  return ROOM_SHARE * roomBehind(seen, robot.position / distance, comfort / ROOM_SHARE);
}

void cutToComfort(const Perception& seen, MoveBlock* moves, std::size_t count) {
  for (const Neighbour& robot : seen.neighbours) {
    if (robot.kind != NeighbourKind::ROBOT || robot.intent.comfort <= 0.0) continue;
    const double distance = robot.position.norm();
    const double gap = distance - seen.self.radius - robot.radius;
    const double reach = seen.motion.reach(seen.self.max_speed, seen.tick_duration);
    if (distance <= 0.0 || gap > robot.intent.comfort + reach + seen.tick_duration * robot.velocity.norm()) continue;
    const Vector2 towards = robot.position / distance;
    const double kept = keptComfort(seen, robot);
    const double left = gap - needOfRobot(towards, seen, robot);
    const double inner = INNER_SHARE * kept;
    const double sidling = kept > 0.0 ? SIDLING * std::clamp((left - inner) / (kept - inner), 0.0, 1.0) : 0.0;
    const double most = speedFor(left - inner, seen) / seen.self.max_speed;
    const double share = std::min(most, speedFor(left - kept, seen) / seen.self.max_speed + sidling);
    for (std::size_t block = 0; block < blocksOf(count); ++block) cutSpeed(towards, share, moves[block]);
  }
}

}  // namespace crowd
