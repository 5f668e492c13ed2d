#include "navigation/right_of_way.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crowd {
namespace {

constexpr double SAMPLE = 0.15;       // distance between the points of a path that are looked up [m]
constexpr double BESIDE_LANE = 0.15;  // between an agent in the lane and agents beside it [m]
constexpr double LANE_LENGTH = 3.0;   // [m]
constexpr double STOP_MARGIN = 0.15;  // agents are held this far outside of the zone [m]
constexpr double ONE_WAY_ZONE = 0.9;  // radius of the zone without traffic in the other direction [m]
// Room for each admitted agent: length along the path [m], and width besides its diameter [m].
constexpr double ONE_WAY_HEADWAY = 0.52;
constexpr double ONE_WAY_MARGIN = 0.13;
constexpr double TWO_WAY_HEADWAY = 0.55;
constexpr double TWO_WAY_MARGIN = 0.15;

constexpr double FILE_MARGIN = 0.1;    // two agents do not walk side by side where less is left beside them [m]
constexpr double FILE_DISTANCE = 0.6;  // from where agents enter one behind the other [m]
constexpr double FILE_GAP = 0.35;      // to the agent ahead [m]
constexpr double FILE_BESIDE = 0.1;    // behind the line beside an agent [m]

constexpr double WAITING_DISTANCE = 1.2;  // from a mouth [m]
constexpr double WAITING_WIDTH = 2.4;     // of the floor there, less the diameter of an agent [m]
constexpr double QUEUE_GAP = 0.2;         // between agents that wait: agents that touch each other block each other [m]

constexpr double ADVANCE = 0.3;  // an admitted agent makes progress when it has come this much closer [m]
constexpr double STALL = 4.0;    // after this time without progress all agents may walk ... [s]
constexpr double RELEASE = 3.0;  // ... for this time [s]

}  // namespace

RightOfWay::RightOfWay(std::shared_ptr<const Passages> passages, double radius)
    : passages_(std::move(passages)), radius_(radius), states_(passages_->size()) {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const auto& mouths = (*passages_)[i].mouths;
    states_[i].is_controlled =
        std::all_of(mouths.begin(), mouths.end(), [this](const Mouth& mouth) { return hasRoomToWait(mouth); });
  }
}

/// Whether agents can wait beside agents that come out.
bool RightOfWay::hasRoomToWait(const Mouth& mouth) const {
  const Vector2 left(-mouth.outward.y(), mouth.outward.x());
  double width = 0.0;
  for (const Vector2& side : {left, Vector2(-left)}) {
    const Vector2 place = mouth.centre + WAITING_DISTANCE * mouth.outward;
    for (double aside = 0.0; width < WAITING_WIDTH && passages_->fits(place + aside * side, radius_); aside += SAMPLE) {
      width += SAMPLE;
    }
  }
  return width >= WAITING_WIDTH;
}

void RightOfWay::update(World& world, const AgentMap<RemainingPath>& paths) {
  if (states_.empty()) return;
  collectClaims(world, paths);
  for (std::size_t passage = 0; passage < states_.size(); ++passage) {
    PassageState& state = states_[passage];
    if (!state.is_controlled) continue;
    dropPassed(world.time(), state);
    if (state.claims.empty()) continue;
    admit(passage, state);
    noteProgress(world, paths, state);
    if (world.time() < state.progress_time + STALL) guide(passage, state, world);
  }
}

void RightOfWay::collectClaims(const World& world, const AgentMap<RemainingPath>& paths) {
  for (PassageState& state : states_) state.claims.clear();
  for (std::size_t i = 0; i < world.agents().size(); ++i) {
    const Agent& agent = world.agents().nth(i);
    if (agent.isWalking()) addClaim(agent, paths.nth(i));
  }
  const auto nearer = [](const Claim& a, const Claim& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.agent < b.agent;
  };
  for (PassageState& state : states_) std::sort(state.claims.begin(), state.claims.end(), nearer);
}

void RightOfWay::addClaim(const Agent& agent, const RemainingPath& path) {
  Vector2 from = agent.pose.position;
  Vector2 before = from;
  double walked = 0.0;
  for (const Vector2& corner : path) {
    const double length = (corner - from).norm();
    const Vector2 direction = length > 0.0 ? Vector2((corner - from) / length) : Vector2::UnitX();
    double step = SAMPLE;
    for (double along = 0.0; along < length && walked + along < LOOKAHEAD; along += step) {
      const Vector2 place = from + along * direction;
      const double clear = passages_->distanceFrom(place);
      const std::uint16_t passage = clear > 0.0 ? Passages::NONE : passages_->at(place);
      if (passage != Passages::NONE) {
        return states_[passage].claims.push_back({agent.id, nearestMouth(passage, before), walked + along});
      }
      step = std::max(SAMPLE, clear);
      before = place + (step - SAMPLE) * direction;
    }
    walked += length;
    from = corner;
    if (walked >= LOOKAHEAD) return;
  }
}

std::size_t RightOfWay::nearestMouth(std::size_t passage, const Vector2& place) const {
  const auto& mouths = (*passages_)[passage].mouths;
  const auto nearer = [&](const Mouth& a, const Mouth& b) {
    return (a.centre - place).squaredNorm() < (b.centre - place).squaredNorm();
  };
  return static_cast<std::size_t>(std::min_element(mouths.begin(), mouths.end(), nearer) - mouths.begin());
}

bool RightOfWay::PassageState::isAdmitted(AgentId agent) const {
  return std::any_of(admitted.begin(), admitted.end(), [agent](const Admitted& other) { return other.agent == agent; });
}

/// Forgets admitted agents that have passed, have left, or have another path now.
void RightOfWay::dropPassed(double time, PassageState& state) {
  const auto passed = [&](const Admitted& admitted) {
    const auto is_its = [&](const Claim& claim) { return claim.agent == admitted.agent; };
    return std::none_of(state.claims.begin(), state.claims.end(), is_its);
  };
  const auto first_passed = std::remove_if(state.admitted.begin(), state.admitted.end(), passed);
  if (first_passed != state.admitted.end() || state.admitted.empty()) state.progress_time = time;
  state.admitted.erase(first_passed, state.admitted.end());
}

/// Agents may block each other, for example if one waits where another one must pass: then all are released for a
/// while.
void RightOfWay::noteProgress(const World& world, const AgentMap<RemainingPath>& paths, PassageState& state) {
  for (Admitted& admitted : state.admitted) {
    const double remaining = lengthOf(paths[admitted.agent], world.agents()[admitted.agent].pose.position);
    if (remaining > admitted.remaining - ADVANCE) continue;
    admitted.remaining = remaining;
    state.progress_time = world.time();
  }
  if (world.time() >= state.progress_time + STALL + RELEASE) state.progress_time = world.time();
}

void RightOfWay::admit(std::size_t passage, PassageState& state) const {
  // Agents inside walk on.
  for (const Claim& claim : state.claims) {
    if (claim.distance == 0.0 && !state.isAdmitted(claim.agent)) state.admitted.push_back({claim.agent});
  }
  if (state.admitted.empty()) chooseDirection(state);
  const auto waits_elsewhere = [&](const Claim& claim) {
    return claim.distance > 0.0 && claim.mouth != state.direction && !state.isAdmitted(claim.agent);
  };
  const bool two_way = std::any_of(state.claims.begin(), state.claims.end(), waits_elsewhere);
  const Spacing room = spacing(passage, two_way);
  for (const Claim& claim : state.claims) {
    if (two_way && state.served >= BATCH_SIZE) return;
    if (claim.mouth != state.direction || state.isAdmitted(claim.agent)) continue;
    const auto is_too_near = [&](const Claim& other) {
      return other.distance > claim.distance - room.length && state.isAdmitted(other.agent);
    };
    const auto too_near = std::count_if(state.claims.begin(), state.claims.end(), is_too_near);
    if (static_cast<std::size_t>(too_near) >= room.abreast) return;
    state.admitted.push_back({claim.agent});
    ++state.served;
  }
}

/// People of one direction walk staggered, so that their number is in proportion to the width, which need not be a
/// multiple of that of a person. With traffic in the other direction they could wedge.
RightOfWay::Spacing RightOfWay::spacing(std::size_t passage, bool two_way) const {
  const double width = (*passages_)[passage].width;
  if (two_way) {
    const double abreast = std::max(1.0, std::floor(width / (2.0 * radius_ + TWO_WAY_MARGIN)));
    return {static_cast<std::size_t>(abreast), TWO_WAY_HEADWAY};
  }
  const double lanes = std::max(1.0, width / (2.0 * radius_ + ONE_WAY_MARGIN));
  const double abreast = std::ceil(lanes);
  return {static_cast<std::size_t>(abreast), ONE_WAY_HEADWAY * abreast / lanes};
}

/// Gives the right of way to the others after a batch, or if no agent of this direction claims it.
void RightOfWay::chooseDirection(PassageState& state) const {
  const auto claims_of = [&](bool same) {
    return std::find_if(state.claims.begin(), state.claims.end(),
                        [&](const Claim& claim) { return (claim.mouth == state.direction) == same; });
  };
  const bool others_wait = claims_of(false) != state.claims.end();
  const bool own_wait = claims_of(true) != state.claims.end();
  if (others_wait && (state.served >= BATCH_SIZE || !own_wait)) {
    state.direction = claims_of(false)->mouth;
    state.served = 0;
  } else if (!others_wait) {
    state.served = 0;
  }
}

void RightOfWay::guide(std::size_t passage, const PassageState& state, World& world) const {
  // Inside, the nearest mouth may be the exit; all agents inside walk in the present direction.
  const auto mouth_of = [&](const Claim& claim) { return claim.distance > 0.0 ? claim.mouth : state.direction; };
  const bool two_way = std::any_of(state.claims.begin(), state.claims.end(), [&](const Claim& claim) {
    return mouth_of(claim) != mouth_of(state.claims.front());
  });
  for (auto claim = state.claims.begin(); claim != state.claims.end(); ++claim) {
    if (state.isAdmitted(claim->agent)) continue;
    if (isBehindAnother(world, state.claims.begin(), claim)) world.walkingAgent(claim->agent).yielding = true;
    guideWaiting((*passages_)[passage].mouths[claim->mouth], two_way, *claim, world);
  }
}

/// Whether an agent with an earlier claim is directly ahead.
bool RightOfWay::isBehindAnother(const World& world, std::vector<Claim>::const_iterator first,
                                 std::vector<Claim>::const_iterator claim) {
  const Agent& agent = world.agents()[claim->agent];
  const Vector2 onward = agent.perceivedGoal() - agent.pose.position;
  return std::any_of(first, claim, [&](const Claim& earlier) {
    const Agent& other = world.agents()[earlier.agent];
    const Vector2 offset = other.pose.position - agent.pose.position;
    return offset.norm() < agent.radius + other.radius + QUEUE_GAP && offset.dot(onward) > 0.0;
  });
}

void RightOfWay::guideWaiting(const Mouth& mouth, bool two_way, const Claim& claim, World& world) const {
  const Vector2 offset = world.agents()[claim.agent].pose.position - mouth.centre;
  const double ahead = offset.dot(mouth.outward);
  const double aside = cross(mouth.outward, offset);
  if (!two_way) {
    if (offset.norm() < ONE_WAY_ZONE + STOP_MARGIN) world.walkingAgent(claim.agent).yielding = true;
    return;
  }
  const double half_lane = 2.0 * radius_ + BESIDE_LANE;
  const bool in_lane = ahead < LANE_LENGTH && std::abs(aside) < half_lane;
  if (!in_lane) {
    const bool enters_next = ahead < LANE_LENGTH + STOP_MARGIN && std::abs(aside) < half_lane + STOP_MARGIN;
    if (enters_next || offset.norm() < LANE_LENGTH) world.walkingAgent(claim.agent).yielding = true;
    return;
  }
  const Vector2 left(-mouth.outward.y(), mouth.outward.x());
  const double side = aside >= 0.0 ? 1.0 : -1.0;
  const double out = std::max(ahead, 2.0 * radius_);
  for (const double to : {side, -side}) {
    const Vector2 place = mouth.centre + out * mouth.outward + to * (half_lane + STOP_MARGIN + 0.1) * left;
    if (passages_->fits(place, radius_) && passages_->fits(place - to * radius_ * left, radius_)) {
      return world.walkingAgent(claim.agent).setWaypoint(place);
    }
  }
  world.walkingAgent(claim.agent).setWaypoint(mouth.centre + (LANE_LENGTH + 1.0) * mouth.outward);
}

void RightOfWay::formSingleFiles(World& world, const DeadlockResolver& deadlocks) const {
  for (std::size_t passage = 0; passage < states_.size(); ++passage) {
    const bool is_narrow = (*passages_)[passage].width <= 4.0 * radius_ + FILE_MARGIN;
    if (!states_[passage].is_controlled && is_narrow) formSingleFile(states_[passage], deadlocks, world);
  }
}

void RightOfWay::formSingleFile(const PassageState& state, const DeadlockResolver& deadlocks, World& world) const {
  for (auto claim = state.claims.begin(); claim != state.claims.end(); ++claim) {
    const bool is_in_front = claim->distance > 0.0 && claim->distance <= FILE_DISTANCE;
    if (!is_in_front || deadlocks.walksBack(claim->agent)) continue;
    const Vector2& course = deadlocks.course(claim->agent);
    const Vector2& place = world.agents()[claim->agent].pose.position;
    const auto is_ahead = [&](const Claim& earlier) {
      if (deadlocks.walksBack(earlier.agent)) return false;
      const Vector2 offset = world.agents()[earlier.agent].pose.position - place;
      const bool is_in_way = earlier.distance == 0.0 || earlier.mouth == claim->mouth;
      return is_in_way && offset.norm() < 2.0 * radius_ + FILE_GAP && offset.dot(course) > -FILE_BESIDE;
    };
    if (std::any_of(state.claims.begin(), claim, is_ahead)) world.walkingAgent(claim->agent).yielding = true;
  }
}

}  // namespace crowd
