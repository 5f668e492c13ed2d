#include "social_crowd/learning/anticipation_states.h"

#include <algorithm>

#include "social_crowd/common/numbers.h"
#include "social_crowd/learning/time_to_contact.h"

namespace crowd {
namespace {

constexpr double LONGEST_TIME = 60.0;      // [s]
constexpr double FASTEST_APPROACH = 10.0;  // [top speeds]

/// How many limits a value reaches.
Row classOf(double value, const std::vector<double>& limits) {
  Row number = 0;
  for (const double limit : limits) number += value >= limit ? 1 : 0;
  return number;
}

/// Fastest approach of another agent if this one walked to its goal at full speed, in units of that.
double fastestApproach(const Perception& perception) {
  const AgentPerception& self = perception.self;
  const Vector2 wish = self.speed * self.goal.normalized();
  double fastest = 0.0;
  for (const PerceivedBody& body : perception.bodies) {
    if (body.kind != BodyKind::AGENT) continue;
    fastest = std::max(fastest, body.position.normalized().dot(wish - body.velocity));
  }
  return fastest / self.speed;
}

}  // namespace

AnticipationStates::AnticipationStates(const Parameters& parameters, std::shared_ptr<const ActionSet> action_set)
    : parameters_(parameters), action_set_(std::move(action_set)) {
  for (const double turn : parameters.turns) turn_limits_.push_back(-std::cos(toRadians(turn)));
  for (const auto* limits : {&parameters_.reciprocal_times, &parameters_.selfish_times, &parameters_.fixed_times,
                             &parameters_.shares, &parameters_.turns, &parameters_.oncoming}) {
    row_count_ *= static_cast<Row>(limits->size() + 1);
  }
}

AnticipationStates::Outlook AnticipationStates::describe(const Perception& perception,
                                                         const CandidateMove& move) const {
  const AgentPerception& self = perception.self;
  const double share = move.wanted > 0.0 ? move.share / move.wanted : 1.0;
  // A move of which the rule leaves nothing is to stay, wherever it was to lead.
  const bool blocked = !parameters_.shares.empty() && share < parameters_.shares.front();
  const Vector2 velocity = (blocked ? 0.0 : move.wanted) * self.speed * move.direction;
  double reciprocal = NEVER;
  double selfish = NEVER;
  double fixed = NEVER;
  for (const PerceivedBody& body : perception.bodies) {
    const double reach = self.radius + body.radius;
    const Vector2 relative = velocity - body.velocity;
    const double time = timeToContact(body.position, relative, reach);
    if (body.kind == BodyKind::OBSTACLE) {
      fixed = std::min(fixed, time);
      continue;
    }
    selfish = std::min(selfish, time);
    reciprocal = std::min(reciprocal, timeToContact(body.position, relative + velocity - self.velocity, reach));
  }
  for (const Segment& wall : perception.walls) fixed = std::min(fixed, timeToContact(wall, velocity, self.radius));
  // What lies behind the goal does not count.
  const double time_to_goal = self.goal.norm() / self.speed;
  const auto before_goal = [&](double time) { return time > time_to_goal ? NEVER : time; };
  const bool had_direction = self.velocity != Vector2::Zero();
  return {before_goal(reciprocal),
          before_goal(selfish),
          before_goal(fixed),
          share,
          had_direction ? move.direction.x() : 1.0,
          0.0};
}

Row AnticipationStates::rowOf(const Outlook& outlook) const {
  Row row = 0;
  const auto append = [&row](double value, const std::vector<double>& limits) {
    row = row * static_cast<Row>(limits.size() + 1) + classOf(value, limits);
  };
  append(outlook.reciprocal_time, parameters_.reciprocal_times);
  append(outlook.selfish_time, parameters_.selfish_times);
  append(outlook.fixed_time, parameters_.fixed_times);
  append(outlook.share, parameters_.shares);
  append(-outlook.turn_cosine, turn_limits_);
  append(outlook.oncoming, parameters_.oncoming);
  return row;
}

void AnticipationStates::findRows(const Perception& perception, Row* rows) const {
  std::vector<CandidateMove> moves(action_set_->size());
  action_set_->findMoves(perception, moves.data());
  const double oncoming = fastestApproach(perception);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    Outlook outlook = describe(perception, moves[i]);
    outlook.oncoming = oncoming;
    rows[i] = rowOf(outlook);
  }
}

std::string AnticipationStates::spec() const {
  return std::string("{type: ") + TYPE + ", vision_radius: " + toText(parameters_.vision_radius) +
         ", max_bodies: " + std::to_string(parameters_.max_bodies) +
         ", reciprocal_times: " + toText(parameters_.reciprocal_times) +
         ", selfish_times: " + toText(parameters_.selfish_times) + ", fixed_times: " + toText(parameters_.fixed_times) +
         ", shares: " + toText(parameters_.shares) + ", turns: " + toText(parameters_.turns) +
         ", oncoming: " + toText(parameters_.oncoming) + "}";
}

std::shared_ptr<const StateSet> readAnticipationStates(YamlMap& map,
                                                       const std::shared_ptr<const ActionSet>& action_set) {
  AnticipationStates::Parameters parameters;
  parameters.vision_radius = map.number("vision_radius", NumberRule::POSITIVE, parameters.vision_radius);
  parameters.max_bodies = static_cast<std::uint32_t>(map.whole("max_bodies", 0, INT32_MAX, parameters.max_bodies));
  const auto read = [&](const char* key, double highest, std::vector<double>& limits) {
    limits = map.risingNumbers(key, 0.0, highest, limits);
  };
  read("reciprocal_times", LONGEST_TIME, parameters.reciprocal_times);
  read("selfish_times", LONGEST_TIME, parameters.selfish_times);
  read("fixed_times", LONGEST_TIME, parameters.fixed_times);
  read("shares", 1.0, parameters.shares);
  read("turns", 180.0, parameters.turns);
  read("oncoming", FASTEST_APPROACH, parameters.oncoming);
  map.finish();
  return std::make_shared<AnticipationStates>(parameters, action_set);
}

}  // namespace crowd
