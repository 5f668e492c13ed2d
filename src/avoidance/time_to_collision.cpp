#include "avoidance/time_to_collision.h"

#include <algorithm>
#include <cmath>

#include "avoidance/comfort.h"
#include "simd/kernels.h"

namespace crowd {
namespace {

constexpr std::size_t LANES = CandidateVelocities::LANES;
static_assert(LANES == simd::CandidateArrays::MAX, "size that kernels expect");
static_assert(NeighbourList::PADDING >= simd::NeighbourArrays::PADDING, "kernels read this far beyond the end");

constexpr double SPACE_SHARE = 0.8;  // of the gap to the nearest other agent, which personal space takes at most

/// The personal space that an agent keeps now: as crowded as it is [m].
double keptSpace(const Perception& seen, double personal_space) {
  if (personal_space <= 0.0) return 0.0;
  for (const Neighbour& neighbour : seen.neighbours) {  // nearest rim first
    if (neighbour.kind != NeighbourKind::AGENT) continue;
    const double gap = neighbour.position.norm() - seen.self.radius - neighbour.radius;
    return std::clamp(SPACE_SHARE * gap, 0.0, personal_space);
  }
  return 0.0;
}

void accumulateAgents(const simd::NeighbourArrays& agents, const AgentPerception& self, const Vector2& preferred,
                      double space, CandidateVelocities& candidates) {
  const simd::Observer observer{self.radius + space, static_cast<float>(self.velocity.x()),
                                static_cast<float>(self.velocity.y()), static_cast<float>(preferred.x()),
                                static_cast<float>(preferred.y())};
  const float fastest =
      simd::kernels().accumulate_time_to_collision(agents, observer,
                                                   {candidates.count, candidates.xs.data(), candidates.ys.data(),
                                                    candidates.constant_velocity.data(), candidates.reciprocal.data()});
  candidates.fastest = std::max(candidates.fastest, fastest);
}

void accumulateFixed(const simd::NeighbourArrays& discs, const AgentPerception& self, CandidateVelocities& candidates) {
  candidates.beginFixed();
  simd::kernels().accumulate_time_to_collision(
      discs, {self.radius, 0.0F, 0.0F, 0.0F, 0.0F},
      {candidates.count, candidates.xs.data(), candidates.ys.data(), candidates.static_bodies.data(), nullptr});
}

/// Updates the times to collision with the long side of a wall: the agent's centre reaches the line at the distance of
/// its radius from the wall, between the ends of the wall.
void accumulateSide(const Segment& wall, double radius, CandidateVelocities& candidates) {
  const double length = (wall.to - wall.from).norm();
  if (length <= 0.0) return;
  const Vector2 along = (wall.to - wall.from) / length;
  const double side = cross(along, wall.from);  // signed distance of the wall's line, positive on the left [m]
  const auto nx = static_cast<float>(side < 0.0 ? along.y() : -along.y());
  const auto ny = static_cast<float>(side < 0.0 ? -along.x() : along.x());
  const auto gap = static_cast<float>(std::max(0.0, std::abs(side) - radius));
  const auto ax = static_cast<float>(along.x());
  const auto ay = static_cast<float>(along.y());
  const auto from = static_cast<float>(wall.from.dot(along));
  const auto to = static_cast<float>(wall.to.dot(along));
  const float per_closing = gap > 0.0F ? 1.0F / gap : simd::AT_ONCE;
  candidates.beginFixed();
  for (std::size_t i = 0; i < LANES; ++i) {
    const float closing = nx * candidates.xs[i] + ny * candidates.ys[i];
    const float walked =
        gap * (ax * candidates.xs[i] + ay * candidates.ys[i]);  // path along the wall until contact, times closing
    const bool beside = walked >= from * closing && walked <= to * closing;
    const float soon = beside ? closing * per_closing : 0.0F;
    candidates.static_bodies[i] = soon > candidates.static_bodies[i] ? soon : candidates.static_bodies[i];
  }
}

/// Collects discs and passes them on in groups of SIZE, the rest in the destructor.
template <typename HandOn>
class Collector {
 public:
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): only the first count_ numbers are read
  explicit Collector(const HandOn& hand_on) : hand_on_(hand_on) {}
  Collector(const Collector&) = delete;
  Collector& operator=(const Collector&) = delete;
  Collector(Collector&&) = delete;
  Collector& operator=(Collector&&) = delete;
  ~Collector() { flush(); }

  void add(const Vector2& place, const Vector2& velocity, double radius) {
    xs_[count_] = place.x();
    ys_[count_] = place.y();
    vxs_[count_] = velocity.x();
    vys_[count_] = velocity.y();
    radii_[count_] = radius;
    if (++count_ == SIZE) flush();
  }

 private:
  static constexpr std::size_t SIZE = simd::NeighbourArrays::PADDING;
  using Numbers = std::array<double, 2 * SIZE>;

  void flush() {
    if (count_ > 0) hand_on_({xs_.data(), ys_.data(), vxs_.data(), vys_.data(), radii_.data(), count_});
    count_ = 0;
  }

  const HandOn& hand_on_;
  std::size_t count_ = 0;
  Numbers xs_;
  Numbers ys_;
  Numbers vxs_;
  Numbers vys_;
  Numbers radii_;
};

}  // namespace

double timeToCollision(const Segment& wall, const Vector2& velocity, double radius) {
  const double ends =
      std::min(timeToCollision(wall.from, velocity, radius), timeToCollision(wall.to, velocity, radius));
  const Vector2 along = (wall.to - wall.from).normalized();
  Vector2 normal(-along.y(), along.x());
  if (normal.dot(wall.from) < 0.0) normal = -normal;
  const double closing = normal.dot(velocity);
  if (closing <= 0.0) return ends;
  const double reached = std::max(0.0, (normal.dot(wall.from) - radius) / closing);
  const double foot =
      (reached * velocity - wall.from).dot(along);  // position of the disc's centre along the wall at contact [m]
  const bool beside = foot >= 0.0 && foot <= (wall.to - wall.from).norm();
  return beside ? std::min(ends, reached) : ends;
}

double timeToCollision(const Perception& perception, const Vector2& velocity) {
  const double radius = perception.self.radius;
  const NeighbourSpan& neighbours = perception.neighbours;
  const double vx = velocity.x();
  const double vy = velocity.y();
  constexpr std::size_t BLOCK = 16;
  std::array<double, BLOCK> times;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  double time = NEVER;
  for (std::size_t first = 0; first < neighbours.size(); first += BLOCK) {
    const std::size_t count = std::min(BLOCK, neighbours.size() - first);
    const double* const xs = neighbours.xs() + first;
    const double* const ys = neighbours.ys() + first;
    const double* const vxs = neighbours.vxs() + first;
    const double* const vys = neighbours.vys() + first;
    const double* const radii = neighbours.radii() + first;
    for (std::size_t i = 0; i < count; ++i) {
      times[i] = timeToCollision(xs[i], ys[i], vx - vxs[i], vy - vys[i], radius + radii[i]);
    }
    for (std::size_t i = 0; i < count; ++i) time = std::min(time, times[i]);
  }
  for (const Segment& wall : perception.walls) time = std::min(time, timeToCollision(wall, velocity, radius));
  return time;
}

void accumulateTimeToCollision(const Perception& seen, const Vector2& preferred, double personal_space,
                               CandidateVelocities& candidates) {
  const AgentPerception& self = seen.self;
  const NeighbourSpan& neighbours = seen.neighbours;
  const double space = keptSpace(seen, personal_space);
  const auto take_agents = [&](const simd::NeighbourArrays& agents) {
    accumulateAgents(agents, self, preferred, space, candidates);
  };
  const auto take_all = [&] {
    take_agents(
        {neighbours.xs(), neighbours.ys(), neighbours.vxs(), neighbours.vys(), neighbours.radii(), neighbours.size()});
  };
  if (seen.isOfAgentsAlone()) return take_all();
  const auto take_static = [&](const simd::NeighbourArrays& discs) { accumulateFixed(discs, self, candidates); };
  Collector static_bodies(take_static);
  if (!neighbours.hasObstacles()) {
    take_all();
  } else {
    Collector agents(take_agents);
    for (const Neighbour& neighbour : neighbours) {
      if (neighbour.kind == NeighbourKind::AGENT) {
        agents.add(neighbour.position, neighbour.velocity, neighbour.radius);
      } else if (isRobot(neighbour.kind) && neighbour.intent.comfort > 0.0) {
        static_bodies.add(neighbour.position, neighbour.intent.wanted, neighbour.radius + keptComfort(seen, neighbour));
      } else {
        static_bodies.add(neighbour.position, neighbour.velocity, neighbour.radius);
      }
    }
  }
  for (const Segment& wall : seen.walls) {
    static_bodies.add(wall.from, Vector2::Zero(), 0.0);
    static_bodies.add(wall.to, Vector2::Zero(), 0.0);
    accumulateSide(wall, self.radius, candidates);
  }
}

}  // namespace crowd
