#include "geometry/solid_motion.h"

#include <algorithm>
#include <limits>

#include "common/heap.h"
#include "common/random.h"
#include "common/text/numbers.h"
#include "geometry/impact.h"

namespace crowd {
namespace {

constexpr double BODY_CELL_SIZE = 1.0;  // [m]; about the space of two agents and their steps
constexpr std::uint32_t WALL = std::numeric_limits<std::uint32_t>::max();

}  // namespace

const std::vector<SolidMotion::Outcome>& SolidMotion::move(const std::vector<Disc>& discs, const WallIndex& walls) {
  walls_ = &walls;
  begin(discs);
  findNeighbours();
  for (Index i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].is_agent) continue;
    predictWallImpacts(i, 0.0);
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
      const Index other = neighbours_[k];
      if (other > i || !bodies_[other].is_agent) predictImpact(i, other, 0.0);
    }
  }
  for (double now = takeNext(); now < NO_IMPACT; now = takeNext()) {
    for (const Impact& impact : simultaneous_) judge(impact);
    settle(now);
  }
  walls_ = nullptr;
  outcomes_.clear();
  for (const Body& body : bodies_) {
    outcomes_.push_back({body.at(1.0), body.touched, body.changes > 0, body.history});
  }
  return outcomes_;
}

void SolidMotion::begin(const std::vector<Disc>& discs) {
  bodies_.clear();
  sweeps_.clear();
  touches_.clear();
  impacts_.clear();
  instant_ = -1.0;
  round_ = 0;
  for (const Disc& disc : discs) {
    Body body;
    body.position = disc.position;
    body.way = disc.way;
    body.radius = disc.radius;
    body.is_agent = disc.is_agent;
    body.speed = disc.sweep ? disc.sweep->pointSpeed() : disc.way.norm();
    body.sliding = disc.sliding;
    if (disc.sliding) body.speed = disc.sweep->slidingSpeed(*disc.sliding);
    if (disc.sweep) {
      body.way.setZero();
      body.sweep = static_cast<Index>(sweeps_.size());
      sweeps_.push_back(*disc.sweep);
    }
    bodies_.push_back(body);
  }
}

void SolidMotion::findNeighbours() {
  double fastest_obstacle = 0.0;
  for (const Body& body : bodies_) {
    if (!body.is_agent && !body.isRobot()) fastest_obstacle = std::max(fastest_obstacle, body.way.norm());
  }
  // Upper bound of the distance that any part of a body reaches: by its own motion, or pushed by an obstacle.
  const auto reach = [&](const Body& body) { return body.radius + std::max(body.speed, fastest_obstacle); };
  grid_.clear();
  for (Index i = 0; i < bodies_.size(); ++i) grid_.add(bodies_[i].position, reach(bodies_[i]), i);
  grid_.build(BODY_CELL_SIZE);
  neighbours_.clear();
  first_.assign(1, 0);
  for (const Body& body : bodies_) {
    if (body.is_agent) grid_.findNear(body.position, reach(body), neighbours_);
    first_.push_back(neighbours_.size());
  }
}

void SolidMotion::predictImpacts(Index agent, double now) {
  predictWallImpacts(agent, now);
  for (std::size_t k = first_[agent]; k < first_[agent + 1]; ++k) predictImpact(agent, neighbours_[k], now);
}

void SolidMotion::predictImpact(Index agent, Index other, double now) {
  if (agent == other) return;
  const Body& body = bodies_[agent];
  const Body& second = bodies_[other];
  if (body.isRobot() || second.isRobot()) {
    const double touch = touchOfRobot(body, second, now);
    if (touch < NO_IMPACT) add({touch, agent, other, body.changes, second.changes});
    return;
  }
  // An agent that was pushed against something is not pushed further: the obstacle passes over it.
  if (!second.is_agent && body.pushed && body.way.isZero(0.0)) return;
  const double after = firstTouch(Vector2(second.at(now) - body.at(now)), Vector2(body.way - second.way),
                                  body.radius + second.radius, 1.0 - now);
  if (after < NO_IMPACT) add({now + after, agent, other, body.changes, second.changes});
}

void SolidMotion::predictWallImpacts(Index agent, double now) {
  const Body& body = bodies_[agent];
  if (body.way.isZero(0.0) && !body.isRobot()) return;
  const Vector2 position = body.isRobot() ? sweeps_[body.sweep].at(now).position : body.at(now);
  double first = NO_IMPACT;
  near_walls_.clear();
  walls_->findNear(position, body.radius + (body.isRobot() ? body.speed : body.way.norm()), near_walls_);
  for (const std::uint32_t number : near_walls_) {
    first = std::min(first, touchOfWall(body, walls_->walls()[number], now));
  }
  if (first == NO_IMPACT) return;
  if (body.isRobot()) {  // in a corner, the next wall may be met before a brief contact with this one is found
    const double touched = first;
    for (const std::uint32_t number : near_walls_) {
      first = std::min(first, touchUntil(sweeps_[body.sweep], walls_->walls()[number], now, touched));
    }
  }
  add({first, agent, WALL, body.changes, 0});
}

double SolidMotion::touchOfWall(const Body& body, const Segment& wall, double now) const {
  if (body.isRobot()) return firstTouch(sweeps_[body.sweep], wall, now);
  const Vector2 position = body.at(now);
  return now + firstTouch(Segment{wall.from - position, wall.to - position}, body.way, body.radius, 1.0 - now);
}

void SolidMotion::add(const Impact& impact) { pushHeap(impacts_, impact, Later()); }

bool SolidMotion::isStale(const Impact& impact) const {
  if (bodies_[impact.agent].changes != impact.agent_changes) return true;
  return impact.other != WALL && bodies_[impact.other].changes != impact.other_changes;
}

double SolidMotion::takeNext() {
  simultaneous_.clear();
  double now = NO_IMPACT;
  while (!impacts_.empty() && impacts_.front().time <= now) {
    const Impact next = popHeap(impacts_, Later());
    if (isStale(next)) continue;
    now = next.time;
    simultaneous_.push_back(next);
  }
  return now;
}

void SolidMotion::judge(const Impact& impact) {
  Body& body = bodies_[impact.agent];
  body.touched = true;
  if (impact.other == WALL) return meetWall(impact.agent);
  Body& other = bodies_[impact.other];
  if (body.isRobot() || other.isRobot()) return judgeRobot(impact);
  const Vector2 ahead = (other.at(impact.time) - body.at(impact.time)).normalized();
  if (!other.is_agent) {
    stop(impact.agent);
    const double closing = -other.way.dot(ahead);
    if (closing <= 0.0) return;
    ++body.pushes;
    body.push = -closing * ahead;
    return;
  }
  other.touched = true;
  const bool body_walks_in = body.way.dot(ahead) > 0.0;
  const bool other_walks_in = other.way.dot(ahead) < 0.0;
  if (body_walks_in || !other_walks_in) stop(impact.agent);
  if (other_walks_in || !body_walks_in) stop(impact.other);
}

void SolidMotion::stop(Index agent) {
  if (!bodies_[agent].judged) judged_.push_back(agent);
  bodies_[agent].judged = true;
  bodies_[agent].stops = true;
}

void SolidMotion::meetWall(Index agent) {
  Body& body = bodies_[agent];
  const bool stops = body.stops;
  stop(agent);
  body.stops = stops || !body.sliding || ++body.slides == MAX_SLIDES;
}

void SolidMotion::slide(Body& body, double now) {
  constexpr double TOUCH = 1e-7;  // [m]
  RobotSweep& sweep = sweeps_[body.sweep];
  const Pose pose = sweep.at(now);
  near_walls_.clear();
  contacts_.clear();
  walls_->findNear(pose.position, sweep.footprint().reach() + TOUCH, near_walls_);
  for (const std::uint32_t wall : near_walls_) {
    addContacts(sweep.footprint(), pose, walls_->walls()[wall], TOUCH, contacts_);
  }
  sweep.slideAt(now, contacts_, *body.sliding);
}

void SolidMotion::record(Body& body) const {
  // What follows from an impact at the same instant is found in the next round, in whichever set of bodies.
  KeyedRandom mixed(body.history, KeyedRandom::CONTENT,
                    {bitsOf(instant_), round_, bitsOf(body.way.x()), bitsOf(body.way.y())});
  body.history = mixed.next();
}

void SolidMotion::settle(double now) {
  round_ = now == instant_ ? round_ + 1 : 0;
  instant_ = now;
  for (const Index agent : judged_) {
    Body& body = bodies_[agent];
    if (body.isRobot()) body.stops ? sweeps_[body.sweep].stopAt(now) : slide(body, now);
    body.stops = false;
    body.position = body.at(now);
    body.since = now;
    body.way = body.pushes == 1 && !body.pushed ? body.push : Vector2::Zero();
    body.pushed = body.pushed || body.pushes > 0;
    ++body.changes;
    record(body);
    body.judged = false;
    body.pushes = 0;
  }
  for (const Index agent : judged_) predictImpacts(agent, now);
  judged_.clear();
}

}  // namespace crowd
