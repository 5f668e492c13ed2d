#include "social_crowd/learning/move_outlooks.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "social_crowd/common/vectorised.h"
#include "social_crowd/learning/time_to_contact.h"

namespace crowd {
namespace {

using Lanes = MoveOutlooks::Lanes;
constexpr std::size_t LANES = MoveOutlooks::LANES;

constexpr float AT_ONCE = 1e30F;  // [1/s]

/// Velocities of the moves, and how soon each would touch something: 1 / time.
struct Courses {
  std::size_t count;
  alignas(64) Lanes ux;  // [m/s]
  alignas(64) Lanes uy;
  alignas(64) Lanes reciprocal;  // [1/s]
  alignas(64) Lanes selfish;
  alignas(64) Lanes fixed;

  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): written below, and zeroing first takes time
  explicit Courses(std::size_t moves) : count(moves) {
    for (Lanes* soonest : {&reciprocal, &selfish, &fixed}) soonest->fill(static_cast<float>(1.0 / NEVER));
  }
};

/// Discs as the agent sees them, side by side. A place that nothing was put at stands for a disc that flies away.
struct Discs {
  static constexpr std::size_t SIZE = 16;
  static constexpr float FLYING = 1e6F;  // [m/s]
  using Floats = std::array<float, SIZE>;

  alignas(64) Floats px;  // [m]
  alignas(64) Floats py;
  alignas(64) Floats vx;  // [m/s]
  alignas(64) Floats vy;
  alignas(64) Floats apart;  // square of the distance less that of the reach, 0 if they overlap [m2]

  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): written by convert(), and zeroing first takes time
  Discs() = default;
  /// Makes those from a number on fly away.
  void leaveOut(std::size_t first) {
    for (std::size_t i = first; i < SIZE; ++i) {
      px[i] = py[i] = apart[i] = 1.0F;
      vx[i] = vy[i] = FLYING;
    }
  }
};

/// Takes over discs as they are given, in double precision; `reach` is from a disc's centre to that of an agent that
/// touches it [m].
CROWD_VECTORISED void convert(const double* px, const double* py, const double* vx, const double* vy,
                              const double* radii, double radius, Discs& discs) {
  for (std::size_t i = 0; i < Discs::SIZE; ++i) {
    const double reach = radius + radii[i];
    const double apart = (px[i] * px[i] + py[i] * py[i]) - reach * reach;
    discs.px[i] = static_cast<float>(px[i]);
    discs.py[i] = static_cast<float>(py[i]);
    discs.vx[i] = static_cast<float>(vx[i]);
    discs.vy[i] = static_cast<float>(vy[i]);
    discs.apart[i] = static_cast<float>(apart > 0.0 ? apart : 0.0);
  }
}

/// Discs that are taken one by one, in double precision.
struct GivenDiscs {
  using Doubles = std::array<double, Discs::SIZE>;

  std::size_t count = 0;
  Doubles px;  // [m]
  Doubles py;
  Doubles vx;  // [m/s]
  Doubles vy;
  Doubles radii;  // [m]

  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): only the first `count` mean anything
  GivenDiscs() = default;
  void add(const Vector2& place, const Vector2& velocity, double radius) {
    px[count] = place.x();
    py[count] = place.y();
    vx[count] = velocity.x();
    vy[count] = velocity.y();
    radii[count++] = radius;
  }
};

using Eight = float __attribute__((vector_size(8 * sizeof(float))));
using Four = float __attribute__((vector_size(4 * sizeof(float))));

/// Of the first and the second half the higher values.
template <typename Half, typename Whole>
inline void fold(const Whole& values, Half& higher) {
  static_assert(sizeof(Whole) == 2 * sizeof(Half), "two halves");
  Half other;
  std::memcpy(&higher, &values, sizeof(Half));
  std::memcpy(&other, reinterpret_cast<const char*>(&values) + sizeof(Half), sizeof(Half));
  higher = higher > other ? higher : other;
}

inline float highest(const Discs::Floats& values) {
  Eight eight;
  Four four;
  fold(values, eight);
  fold(eight, four);
  return std::max(std::max(four[0], four[1]), std::max(four[2], four[3]));
}

/// Of the roots of |p - t r| = reach, t = apart / (p.r + sqrt(inside)) is the smaller one. Returns its inverse; what is
/// not real, or behind (negative), fails in comparisons with what is above 0.
inline float inverseTime(float px, float py, float rx, float ry, float apart, float per_root) {
  const float closing = px * rx + py * ry;
  const float square = rx * rx + ry * ry;
  return (closing + std::sqrt(closing * closing - square * apart)) * per_root;
}

/// Notes contacts with the first `count` discs. Few of them would leave lanes idle: then moves are side by side.
/// @param vx velocities of the discs instead of their own
inline void noteContacts(const Courses& courses, const Discs& discs, std::size_t count, const Discs::Floats& vx,
                         const Discs::Floats& vy, Lanes& soonest) {
  constexpr std::size_t FEW = 5;
  alignas(64) Discs::Floats per_root;
  for (std::size_t i = 0; i < Discs::SIZE; ++i) per_root[i] = discs.apart[i] > 0.0F ? 1.0F / discs.apart[i] : AT_ONCE;
  if (count <= FEW) {
    for (std::size_t i = 0; i < count; ++i) {
      const float px = discs.px[i];
      const float py = discs.py[i];
      for (std::size_t move = 0; move < LANES; ++move) {
        const float soon =
            inverseTime(px, py, courses.ux[move] - vx[i], courses.uy[move] - vy[i], discs.apart[i], per_root[i]);
        soonest[move] = soon > soonest[move] ? soon : soonest[move];
      }
    }
    return;
  }
  for (std::size_t move = 0; move < courses.count; ++move) {
    const float ux = courses.ux[move];
    const float uy = courses.uy[move];
    alignas(64) Discs::Floats inverses;
    for (std::size_t i = 0; i < Discs::SIZE; ++i) {
      const float soon = inverseTime(discs.px[i], discs.py[i], ux - vx[i], uy - vy[i], discs.apart[i], per_root[i]);
      inverses[i] = soon > 0.0F ? soon : 0.0F;
    }
    soonest[move] = std::max(soonest[move], highest(inverses));
  }
}

/// The square of the fastest approach of any disc, seen with a velocity [m2/s2].
inline float fastestApproach(const Discs& discs, const Vector2& velocity) {
  const auto x = static_cast<float>(velocity.x());
  const auto y = static_cast<float>(velocity.y());
  alignas(64) Discs::Floats squares;
  for (std::size_t i = 0; i < Discs::SIZE; ++i) {
    const float closing = discs.px[i] * (x - discs.vx[i]) + discs.py[i] * (y - discs.vy[i]);
    const float square = closing * closing / (discs.px[i] * discs.px[i] + discs.py[i] * discs.py[i]);
    squares[i] = closing > 0.0F ? square : 0.0F;
  }
  return highest(squares);
}

/// Notes contacts with agents, and the square of their fastest approach if this one walked with the velocity `wish`.
CROWD_VECTORISED void noteAgents(const Discs& agents, std::size_t count, const Vector2& velocity, const Vector2& wish,
                                 Courses& courses, float& fastest) {
  noteContacts(courses, agents, count, agents.vx, agents.vy, courses.selfish);
  // At 2u - w - v contact comes in half of the time that it takes at u - (w + v) / 2.
  alignas(64) Discs::Floats mean_vx;
  alignas(64) Discs::Floats mean_vy;
  const auto wx = static_cast<float>(velocity.x());
  const auto wy = static_cast<float>(velocity.y());
  for (std::size_t i = 0; i < Discs::SIZE; ++i) mean_vx[i] = 0.5F * (wx + agents.vx[i]);
  for (std::size_t i = 0; i < Discs::SIZE; ++i) mean_vy[i] = 0.5F * (wy + agents.vy[i]);
  noteContacts(courses, agents, count, mean_vx, mean_vy, courses.reciprocal);
  fastest = std::max(fastest, fastestApproach(agents, wish));
}

CROWD_VECTORISED void noteFixed(const Discs& discs, std::size_t count, Courses& courses) {
  noteContacts(courses, discs, count, discs.vx, discs.vy, courses.fixed);
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

/// Takes discs one by one and notes them Discs::SIZE at a time.
template <typename Note>
class Collector {
 public:
  /// @param radius of the agent [m]
  Collector(double radius, const Note& note) : radius_(radius), note_(note) {}
  void add(const Vector2& place, const Vector2& velocity, double radius) {
    given_.add(place, velocity, radius);
    if (given_.count == Discs::SIZE) noteAll();
  }
  void noteAll() {
    if (given_.count == 0) return;
    Discs discs;
    convert(given_.px.data(), given_.py.data(), given_.vx.data(), given_.vy.data(), given_.radii.data(), radius_,
            discs);
    discs.leaveOut(given_.count);
    note_(discs, given_.count);
    given_.count = 0;
  }

 private:
  double radius_;
  const Note& note_;
  GivenDiscs given_;
};

/// Notes contacts with bodies and with walls. Returns the fastest approach of another agent if this one walked with the
/// velocity `wish` [m/s].
float noteAll(const Perception& perception, const Vector2& wish, Courses& courses) {
  const AgentPerception& self = perception.self;
  float fastest = 0.0F;  // squared
  const auto note_agents = [&](const Discs& discs, std::size_t count) {
    noteAgents(discs, count, self.velocity, wish, courses, fastest);
  };
  const auto note_fixed = [&](const Discs& discs, std::size_t count) { noteFixed(discs, count, courses); };
  Collector agents(self.radius, note_agents);
  Collector fixed(self.radius, note_fixed);
  for (const PerceivedBody& body : perception.bodies) {
    if (body.kind == BodyKind::AGENT) {
      agents.add(body.position, body.velocity, body.radius);
    } else {
      fixed.add(body.position, body.velocity, body.radius);
    }
  }
  for (const Segment& wall : perception.walls) {
    for (const Vector2* end : {&wall.from, &wall.to}) fixed.add(*end, Vector2::Zero(), 0.0);
    noteSide(wall, self.radius, courses);
  }
  agents.noteAll();
  fixed.noteAll();
  return std::sqrt(fastest);
}

/// The same where there is nobody but agents: they are side by side already.
float noteAgentsAlone(const Perception& perception, const Vector2& wish, Courses& courses) {
  static_assert(Discs::SIZE <= PerceivedBodies::MARGIN, "all lanes can be read");
  const AgentPerception& self = perception.self;
  const PerceivedBodiesView& bodies = perception.bodies;
  float fastest = 0.0F;  // squared
  for (std::size_t i = 0; i < bodies.size(); i += Discs::SIZE) {
    const std::size_t count = std::min(Discs::SIZE, bodies.size() - i);
    Discs discs;
    convert(bodies.xs() + i, bodies.ys() + i, bodies.vxs() + i, bodies.vys() + i, bodies.radii() + i, self.radius,
            discs);
    discs.leaveOut(count);
    noteAgents(discs, count, self.velocity, wish, courses, fastest);
  }
  return std::sqrt(fastest);
}

/// What lies behind the goal does not count.
/// @param unit of the times that the inverses stand for [s]
CROWD_VECTORISED void toTimes(const Lanes& soonest, float unit, float time_to_goal, Lanes& times) {
  for (std::size_t i = 0; i < LANES; ++i) {
    const float time = unit / soonest[i];
    times[i] = time > time_to_goal ? static_cast<float>(NEVER) : time;
  }
}

/// Of a move of which the rule leaves too little the course is that of staying.
CROWD_VECTORISED void findCourses(const MoveBlock& moves, float speed, float least_share, Lanes& shares,
                                  Courses& courses) {
  for (std::size_t i = 0; i < LANES; ++i) {
    const auto wanted = static_cast<float>(moves.wanted[i]);
    const float share = static_cast<float>(moves.share[i]) / wanted;
    shares[i] = wanted > 0.0F ? share : 1.0F;
    const float pace = shares[i] < least_share ? 0.0F : wanted * speed;
    courses.ux[i] = pace * static_cast<float>(moves.x[i]);
    courses.uy[i] = pace * static_cast<float>(moves.y[i]);
  }
}

/// @param walking whether the agent walked in the last tick: else no move is a turn
CROWD_VECTORISED void findTurns(const MoveBlock& moves, bool walking, Lanes& cosines) {
  for (std::size_t i = 0; i < LANES; ++i) cosines[i] = walking ? static_cast<float>(moves.x[i]) : 1.0F;
}

}  // namespace

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): written below, and zeroing first takes time
MoveOutlooks::MoveOutlooks(const Perception& perception, const MoveBlock& moves, std::size_t count,
                           double least_share) {
  const AgentPerception& self = perception.self;
  const auto speed = static_cast<float>(self.speed);
  const double distance = self.goal.norm();
  Courses courses(count);
  findCourses(moves, speed, static_cast<float>(least_share), shares, courses);
  findTurns(moves, self.velocity != Vector2::Zero(), turn_cosines);
  const double pace_to_goal = distance > 0.0 ? self.speed / distance : 0.0;
  const bool alone = perception.walls.empty() && !perception.bodies.hasObstacles();
  const Vector2 wish = pace_to_goal * self.goal;
  oncoming = (alone ? noteAgentsAlone(perception, wish, courses) : noteAll(perception, wish, courses)) / speed;
  const auto time_to_goal = static_cast<float>(distance / self.speed);
  toTimes(courses.reciprocal, 0.5F, time_to_goal, reciprocal_times);
  toTimes(courses.selfish, 1.0F, time_to_goal, selfish_times);
  toTimes(courses.fixed, 1.0F, time_to_goal, fixed_times);
}

}  // namespace crowd
