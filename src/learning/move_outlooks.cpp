#include "social_crowd/learning/move_outlooks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "social_crowd/common/vectorised.h"
#include "social_crowd/learning/contact_times.h"
#include "social_crowd/learning/time_to_contact.h"

namespace crowd {
namespace {

using Lanes = MoveOutlooks::Lanes;
constexpr std::size_t LANES = MoveOutlooks::LANES;

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
  courses.any_fixed = true;
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

/// Notes contacts with bodies and with walls.
void noteAll(const Perception& seen, Courses& courses) {
  const auto note_agents = [&](const Discs& discs, std::size_t count) {
    const Encounter encounter = {discs, count, &courses};
    noteAgents({&encounter, 1});
  };
  const auto note_fixed = [&](const Discs& discs, std::size_t count) { noteFixed(discs, count, courses); };
  const double radius = seen.self.radius;
  Collector agents(radius, note_agents);
  Collector fixed(radius, note_fixed);
  for (const PerceivedBody& body : seen.bodies) {
    if (body.kind == BodyKind::AGENT) {
      agents.add(body.position, body.velocity, body.radius);
    } else {
      fixed.add(body.position, body.velocity, body.radius);
    }
  }
  for (const Segment& wall : seen.walls) {
    for (const Vector2* end : {&wall.from, &wall.to}) fixed.add(*end, Vector2::Zero(), 0.0);
    noteSide(wall, radius, courses);
  }
  agents.noteAll();
  fixed.noteAll();
}

// The steps of foresee(), each for all agents. What is in them is no function of its own, so that it is compiled
// together with the loop over the agents for each kind of vector instructions.

/// Of a move of which the rule leaves too little the course is that of staying.
[[gnu::always_inline]] inline void findCourse(const MoveBlock& moves, float least_share, Lanes& shares,
                                              Courses& courses) {
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
[[gnu::always_inline]] inline void findTurns(const MoveBlock& moves, bool walking, Lanes& cosines) {
  for (std::size_t i = 0; i < LANES; ++i) cosines[i] = walking ? static_cast<float>(moves.x[i]) : 1.0F;
}

CROWD_VECTORISED void begin(const Choosers& choosers, std::size_t block, std::size_t count, double least_share,
                            MoveOutlooks* outlooks, Courses* courses) {
  for (std::size_t k = 0; k < choosers.size(); ++k) {
    const AgentPerception& self = choosers[k].seen.self;
    const MoveBlock& moves = choosers[k].moves[block];
    const double distance = self.goal.norm();
    const double pace_to_goal = distance > 0.0 ? self.speed / distance : 0.0;
    courses[k].count = count;
    courses[k].speed = static_cast<float>(self.speed);
    courses[k].velocity = self.velocity;
    courses[k].wish = pace_to_goal * self.goal;
    courses[k].time_to_goal = static_cast<float>(distance / self.speed);
    courses[k].touchNothing();
    findCourse(moves, static_cast<float>(least_share), outlooks[k].shares, courses[k]);
    findTurns(moves, self.velocity != Vector2::Zero(), outlooks[k].turn_cosines);
  }
}

/// @param radius of the agent [m]
[[gnu::always_inline]] inline void convert(const PerceivedBodiesView& bodies, double radius, Discs& discs) {
  static_assert(Discs::SIZE <= PerceivedBodies::MARGIN, "all lanes can be read");
  const double* const px = bodies.xs();
  const double* const py = bodies.ys();
  const double* const vx = bodies.vxs();
  const double* const vy = bodies.vys();
  const double* const radii = bodies.radii();
  for (std::size_t i = 0; i < Discs::SIZE; ++i) discs.put(i, {px[i], py[i]}, {vx[i], vy[i]}, radius + radii[i]);
  discs.leaveOut(bodies.size());
}

/// Whether all that is seen are agents that are side by side already.
bool isEncounter(const Perception& seen) { return seen.bodies.size() <= Discs::SIZE && seen.isOfAgentsAlone(); }

/// @return how many encounters there are
CROWD_VECTORISED std::size_t listEncounters(const Choosers& choosers, Courses* courses, Encounter* encounters) {
  std::size_t size = 0;
  for (std::size_t k = 0; k < choosers.size(); ++k) {
    const Perception& seen = choosers[k].seen;
    if (seen.bodies.empty() || !isEncounter(seen)) continue;
    Encounter& encounter = encounters[size++];
    encounter.count = seen.bodies.size();
    encounter.courses = &courses[k];
    convert(seen.bodies, seen.self.radius, encounter.discs);
  }
  return size;
}

/// What lies behind the goal does not count.
/// @param unit of the times that the inverses stand for [s]
[[gnu::always_inline]] inline void toTimes(const Lanes& soonest, float unit, float time_to_goal, Lanes& times) {
  for (std::size_t i = 0; i < LANES; ++i) {
    const float time = unit / soonest[i];
    times[i] = time > time_to_goal ? static_cast<float>(NEVER) : time;
  }
}

CROWD_VECTORISED void finish(const Courses* courses, std::size_t size, MoveOutlooks* outlooks) {
  for (std::size_t k = 0; k < size; ++k) {
    const Courses& course = courses[k];
    MoveOutlooks& outlook = outlooks[k];
    outlook.oncoming = std::sqrt(course.fastest) / course.speed;
    toTimes(course.reciprocal, 0.5F, course.time_to_goal, outlook.reciprocal_times);
    toTimes(course.selfish, 1.0F, course.time_to_goal, outlook.selfish_times);
    if (course.any_fixed) {
      toTimes(course.fixed, 1.0F, course.time_to_goal, outlook.fixed_times);
    } else {
      outlook.fixed_times.fill(static_cast<float>(NEVER));
    }
  }
}

}  // namespace

void foresee(const Choosers& choosers, std::size_t block, std::size_t count, double least_share,
             MoveOutlooks* outlooks) {
  std::array<Courses, MAX_CHOOSERS> courses;         // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  std::array<Encounter, MAX_ENCOUNTERS> encounters;  // NOLINT(cppcoreguidelines-pro-type-member-init): likewise
  begin(choosers, block, count, least_share, outlooks, courses.data());
  const std::size_t size = listEncounters(choosers, courses.data(), encounters.data());
  noteAgents({encounters.data(), size});
  for (std::size_t k = 0; k < choosers.size(); ++k) {
    if (!isEncounter(choosers[k].seen)) noteAll(choosers[k].seen, courses[k]);
  }
  finish(courses.data(), choosers.size(), outlooks);
}

}  // namespace crowd
