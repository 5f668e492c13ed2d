#include "social_crowd/learning/move_outlooks.h"

#include <algorithm>
#include <cmath>

#include "social_crowd/common/vectorised.h"
#include "social_crowd/learning/time_to_contact.h"

namespace crowd {
namespace {

using Lanes = MoveOutlooks::Lanes;
constexpr std::size_t LANES = MoveOutlooks::LANES;

constexpr float AT_ONCE = 1e30F;  // [1/s]

/// Velocities of the moves, and how soon each would touch something: 1 / time, 0 for never.
struct Courses {
  alignas(32) Lanes ux;  // [m/s]
  alignas(32) Lanes uy;
  alignas(32) Lanes reciprocal{};  // [1/s]
  alignas(32) Lanes selfish{};
  alignas(32) Lanes fixed{};
};

/// Another disc, seen from the agent.
struct Other {
  float px;  // [m]
  float py;
  float apart;  // square of the distance less that of the reach, 0 if they overlap [m2]
};

Other otherAt(const Vector2& place, double reach) {
  const double apart = place.squaredNorm() - reach * reach;
  return {static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(std::max(0.0, apart))};
}

/// Of the roots of |p - t r| = reach, t = apart / (p.r + sqrt(inside)) is the smaller one; of its inverse, the largest
/// is kept. Where it is not real, or behind (negative), the comparison fails. `pace` is by how much faster time goes.
inline void noteContacts(const Courses& courses, const Other& other, float vx, float vy, float pace, Lanes& soonest) {
  const float per_root = other.apart > 0.0F ? pace / other.apart : AT_ONCE;
  for (std::size_t i = 0; i < LANES; ++i) {
    const float rx = courses.ux[i] - vx;
    const float ry = courses.uy[i] - vy;
    const float closing = other.px * rx + other.py * ry;
    const float square = rx * rx + ry * ry;
    const float soon = (closing + std::sqrt(closing * closing - square * other.apart)) * per_root;
    soonest[i] = soon > soonest[i] ? soon : soonest[i];
  }
}

/// Returns the fastest approach of another agent if this one walked with the velocity `wish` [m/s].
CROWD_VECTORISED float noteBodies(const Perception& perception, const Vector2& wish, Courses& courses) {
  const AgentPerception& self = perception.self;
  const auto wx = static_cast<float>(self.velocity.x());
  const auto wy = static_cast<float>(self.velocity.y());
  const auto goal_x = static_cast<float>(wish.x());
  const auto goal_y = static_cast<float>(wish.y());
  float fastest = 0.0F;  // squared
  for (const PerceivedBody& body : perception.bodies) {
    const Other other = otherAt(body.position, self.radius + body.radius);
    const auto vx = static_cast<float>(body.velocity.x());
    const auto vy = static_cast<float>(body.velocity.y());
    if (body.kind == BodyKind::OBSTACLE) {
      noteContacts(courses, other, vx, vy, 1.0F, courses.fixed);
      continue;
    }
    noteContacts(courses, other, vx, vy, 1.0F, courses.selfish);
    // At 2u - w - v contact comes in half of the time that it takes at u - (w + v) / 2.
    noteContacts(courses, other, 0.5F * (wx + vx), 0.5F * (wy + vy), 2.0F, courses.reciprocal);
    const float closing = std::max(0.0F, other.px * (goal_x - vx) + other.py * (goal_y - vy));
    const float square = closing * closing / (other.px * other.px + other.py * other.py);
    fastest = square > fastest ? square : fastest;
  }
  return std::sqrt(fastest);
}

/// The wall's long side is reached where the line along it, moved by the radius, is crossed beside it.
CROWD_VECTORISED void noteSide(const Segment& wall, double radius, Courses& courses) {
  const double length = (wall.to - wall.from).norm();
  if (length <= 0.0) return;
  const Vector2 along = (wall.to - wall.from) / length;
  const double side = cross(along, wall.from);  // how far to the left of the agent
  const auto nx = static_cast<float>(side < 0.0 ? along.y() : -along.y());
  const auto ny = static_cast<float>(side < 0.0 ? -along.x() : along.x());
  const auto gap = static_cast<float>(std::max(0.0, std::abs(side) - radius));
  const auto ax = static_cast<float>(along.x());
  const auto ay = static_cast<float>(along.y());
  const auto from = static_cast<float>(wall.from.dot(along));
  const auto to = static_cast<float>(wall.to.dot(along));
  const float per_closing = gap > 0.0F ? 1.0F / gap : AT_ONCE;
  for (std::size_t i = 0; i < LANES; ++i) {
    const float closing = nx * courses.ux[i] + ny * courses.uy[i];
    const float walked = gap * (ax * courses.ux[i] + ay * courses.uy[i]);  // along the wall till then, times closing
    const bool beside = walked >= from * closing && walked <= to * closing;
    const float soon = beside ? closing * per_closing : 0.0F;
    courses.fixed[i] = soon > courses.fixed[i] ? soon : courses.fixed[i];
  }
}

CROWD_VECTORISED void noteEnds(const Segment& wall, double radius, Courses& courses) {
  for (const Vector2* end : {&wall.from, &wall.to}) {
    noteContacts(courses, otherAt(*end, radius), 0.0F, 0.0F, 1.0F, courses.fixed);
  }
}

/// What lies behind the goal does not count.
CROWD_VECTORISED void toTimes(const Lanes& soonest, float time_to_goal, Lanes& times) {
  for (std::size_t i = 0; i < LANES; ++i) {
    const float time = 1.0F / soonest[i];
    times[i] = time > time_to_goal ? static_cast<float>(NEVER) : time;
  }
}

/// Moves side by side.
struct MoveLanes {
  alignas(32) Lanes x{};  // direction
  alignas(32) Lanes y{};
  alignas(32) Lanes wanted{};
  alignas(32) Lanes left{};  // by the contact rule

  MoveLanes(const CandidateMove* moves, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = static_cast<float>(moves[i].direction.x());
      y[i] = static_cast<float>(moves[i].direction.y());
      wanted[i] = static_cast<float>(moves[i].wanted);
      left[i] = static_cast<float>(moves[i].share);
    }
  }
};

/// Of a move of which the rule leaves too little the course is that of staying.
CROWD_VECTORISED void findCourses(const MoveLanes& moves, float speed, float least_share, Lanes& shares,
                                  Courses& courses) {
  for (std::size_t i = 0; i < LANES; ++i) {
    const float share = moves.left[i] / moves.wanted[i];
    shares[i] = moves.wanted[i] > 0.0F ? share : 1.0F;
    const float pace = shares[i] < least_share ? 0.0F : moves.wanted[i] * speed;
    courses.ux[i] = pace * moves.x[i];
    courses.uy[i] = pace * moves.y[i];
  }
}

}  // namespace

MoveOutlooks::MoveOutlooks(const Perception& perception, const CandidateMove* moves, std::size_t count,
                           double least_share) {
  const AgentPerception& self = perception.self;
  const auto speed = static_cast<float>(self.speed);
  const double distance = self.goal.norm();
  const MoveLanes lanes(moves, count);
  Courses courses;
  findCourses(lanes, speed, static_cast<float>(least_share), shares, courses);
  turn_cosines = lanes.x;
  if (self.velocity == Vector2::Zero()) turn_cosines.fill(1.0F);
  const double pace_to_goal = distance > 0.0 ? self.speed / distance : 0.0;
  oncoming = noteBodies(perception, pace_to_goal * self.goal, courses) / speed;
  for (const Segment& wall : perception.walls) {
    noteEnds(wall, self.radius, courses);
    noteSide(wall, self.radius, courses);
  }
  const auto time_to_goal = static_cast<float>(distance / self.speed);
  toTimes(courses.reciprocal, time_to_goal, reciprocal_times);
  toTimes(courses.selfish, time_to_goal, selfish_times);
  toTimes(courses.fixed, time_to_goal, fixed_times);
}

}  // namespace crowd
