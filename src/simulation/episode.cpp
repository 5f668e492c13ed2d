#include "simulation/episode.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "robots/metrics/aggregated_time.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

Scene withFirstGoals(Scene scene, const StopRequest& stop) {
  Population::chooseFirstGoals(scene, stop);
  return scene;
}

/// When the last person arrived [s]; NaN if somebody who was to arrive did not.
double timeOfPeople(const AgentResults& agents, double tick_duration) {
  std::uint64_t last = 0;
  for (const AgentResult& agent : agents) {
    if (agent.removed || (agent.endless && !agent.arrived)) continue;
    if (!agent.arrived) return RobotResult::NONE;
    last = std::max(last, agent.appeared + agent.ticks);
  }
  return static_cast<double>(last) * tick_duration;
}

}  // namespace

Episode::Episode(Scene scene, std::uint64_t number, const Vision& vision, ThreadPool& thread_pool, StopRequest stop)
    : scene_(withFirstGoals(std::move(scene), stop)),
      world_(scene_, std::move(stop)),
      vision_(vision),
      thread_pool_(&thread_pool),
      monitor_(scene_, world_),
      robot_monitor_(scene_, world_),
      population_(scene_),
      way_finder_(scene_),
      way_lengths_(scene_),
      number_(number) {
  setVision(vision);
  population_.begin(world_, monitor_);
  noteChange();
}

void Episode::noteChange() {
  ++changes_;
  are_current_ = false;
  try {
    way_finder_.update(world_);
  } catch (const InputError& error) {  // the floor is too large
    way_finding_problem_ = error.what();
    way_finder_.giveUp(world_);
  }
}

void Episode::setVision(const Vision& vision) {
  vision_ = vision;
  world_.setMotion(scene_.motion ? *scene_.motion : vision.motion.value_or(MotionLimits()));
  are_current_ = false;
}

bool Episode::walk(Decider& decider) {
  if (!decider.decide(*this, actions_)) return false;  // it may be gone
  step(actions_, &decider);
  return true;
}

bool Episode::step(const std::vector<AgentAction>& actions, Decider* decider) {
  world_.stopRequest().throwIfMade();
  begins_tick_ = move(actions, decider);
  if (!begins_tick_) return false;
  population_.update(world_, monitor_);
  world_.stopRequest().throwIfMade();
  monitor_.observe(world_, *thread_pool_);
  robot_monitor_.observe(world_);
  noteChange();
  return true;
}

bool Episode::move(const std::vector<AgentAction>& actions, Decider* decider) {
  if (!isSequential()) {
    world_.beginStep(actions, *thread_pool_);
    if (decider != nullptr && world_.contact() == Contact::SOLID) decider->agree(world_);
    world_.stopRequest().throwIfMade();
    world_.endStep(*thread_pool_);
    return true;
  }
  world_.moveAgent(turn_, actions);
  are_current_ = false;
  ++turn_;
  if (findTurn()) return false;
  world_.endTick(*thread_pool_);
  turn_ = 0;
  return true;
}

bool Episode::findTurn() {
  const AgentMap<Agent>& agents = world_.agents();
  std::size_t position = agents.lowerBound(turn_);
  while (position < agents.size() && !world_.isPerceiving(agents.nth(position))) ++position;
  const bool found = position < agents.size();
  turn_ = found ? agents.idAt(position) : static_cast<AgentId>(world_.enteredCount());
  return found;
}

bool Episode::isOver() const {
  if (world_.tick() >= scene_.max_ticks) return true;
  const bool crowd_is_done = world_.activeCount() == 0 && !population_.expectsAgents();
  if (world_.robots().empty()) return crowd_is_done && (world_.enteredCount() > 0 || scene_.recorded.empty());
  bool has_goal = false;
  for (const Robot& robot : world_.robots()) {
    if (robot.sent || (robot.hasGoal() && !robot.hasArrived())) return false;
    has_goal = has_goal || robot.hasGoal();
  }
  if (scene_.ends == Ends::ROBOTS) return has_goal;
  return crowd_is_done && (has_goal || world_.enteredCount() > 0);
}

EpisodeResult Episode::result() const {
  EpisodeResult result = monitor_.result();
  result.robots = robot_monitor_.results();
  if (!result.robots.empty()) writeAggregatedTime(timeOfPeople(result.agents, world_.tickDuration()), result.robots);
  result.way_finding_problem = way_finding_problem_;
  if (!findsWays()) return result;
  for (const Agent& agent : world_.agents()) {
    if (agent.isWalking()) result.agents.add(agent.id).out_of_reach = way_finder_.isOutOfReach(agent.id);
  }
  return result;
}

const Perceptions& Episode::perceptions() {
  if (are_current_) return *perceptions_;
  if (may_be_held_) {
    perceptions_.reset();
    perceptions_ = buffers_.next();
    may_be_held_ = false;
  }
  perceptions_->turn = 0;
  perceiver_.perceive(world_, vision_, viewersOfTurn(), *perceptions_);
  perceptions_->episode = number_;
  perceptions_->last = isOver();
  are_current_ = true;
  return *perceptions_;
}

std::shared_ptr<const Perceptions> Episode::sharedPerceptions() {
  perceptions();
  may_be_held_ = true;
  return perceptions_;
}

const Viewers& Episode::viewersOfTurn() {
  if (!isSequential() || isOver()) return viewers_.all(world_);
  // There is no agent if the remaining ones were removed after the previous turn.
  const bool found = findTurn();
  perceptions_->turn = turn_;
  return viewers_.one(world_, found ? std::optional<AgentId>(turn_) : std::nullopt);
}

}  // namespace crowd
