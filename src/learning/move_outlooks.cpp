#include "social_crowd/learning/move_outlooks.h"

#include <algorithm>
#include <cmath>

#include "social_crowd/common/vectorised.h"
#include "social_crowd/learning/contact_times.h"
#include "social_crowd/learning/time_to_contact.h"

namespace crowd {
namespace {

using Lanes = MoveOutlooks::Lanes;
constexpr std::size_t LANES = MoveOutlooks::LANES;

/// Takes over `count` bodies from a number on.
/// @param radius of the agent [m]
CROWD_VECTORISED void convert(const PerceivedBodiesView& bodies, std::size_t first, std::size_t count, double radius,
                              Discs& discs) {
  const double* const px = bodies.xs() + first;
  const double* const py = bodies.ys() + first;
  const double* const vx = bodies.vxs() + first;
  const double* const vy = bodies.vys() + first;
  const double* const radii = bodies.radii() + first;
  for (std::size_t i = 0; i < Discs::SIZE; ++i) discs.put(i, {px[i], py[i]}, {vx[i], vy[i]}, radius + radii[i]);
  discs.leaveOut(count);
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
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): only the first `count_` discs mean anything
  Collector(double radius, const Note& note) : radius_(radius), note_(note) {}
  void add(const Vector2& place, const Vector2& velocity, double radius) {
    discs_.put(count_++, place, velocity, radius_ + radius);
    if (count_ == Discs::SIZE) noteAll();
  }
  void noteAll() {
    if (count_ == 0) return;
    discs_.leaveOut(count_);
    note_(discs_, count_);
    count_ = 0;
  }

 private:
  double radius_;
  const Note& note_;
  Discs discs_;
  std::size_t count_ = 0;
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
    Discs discs;  // NOLINT(cppcoreguidelines-pro-type-member-init): convert() writes them
    convert(bodies, i, count, self.radius, discs);
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
CROWD_VECTORISED void findCourses(const MoveBlock& moves, float least_share, Lanes& shares, Courses& courses) {
  const float speed = courses.speed;
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
  Courses courses(count, speed);
  findCourses(moves, static_cast<float>(least_share), shares, courses);
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
