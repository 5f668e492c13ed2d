#include "social_crowd/episode.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "common/thread_pool.h"
#include "library/conversions.h"
#include "robots/robot_senses.h"
#include "scenario/scenario.h"
#include "simulation/crowd_decider.h"
#include "simulation/episode.h"
#include "world/world_editor.h"

namespace crowd::library {
namespace {

/// Decides by a function of the user.
class OwnDecider final : public Decider {
 public:
  OwnDecider(const Decide& decide, Perceptions& perceptions) : decide_(decide), perceptions_(perceptions) {}

  bool decide(crowd::Episode& episode, std::vector<AgentAction>& actions) override {
    toPublic(episode.perceptions(), perceptions_);
    fromPublic(decide_(perceptions_), actions);
    return !episode.isOver();
  }

 private:
  const Decide& decide_;
  Perceptions& perceptions_;
};

/// Carries out given actions.
class GivenActions final : public Decider {
 public:
  explicit GivenActions(const std::vector<Action>& actions) { fromPublic(actions, actions_); }

  bool decide(crowd::Episode& episode, std::vector<AgentAction>& actions) override {
    if (episode.scene().order != Order::SEQUENTIAL) {
      actions = actions_;
      return !episode.isOver();
    }
    actions.clear();
    for (const AgentPerception& seen : episode.perceptions().agents) {  // of one turn
      const auto is_its = [&](const AgentAction& action) { return action.agent == seen.agent; };
      std::copy_if(actions_.begin(), actions_.end(), std::back_inserter(actions), is_its);
    }
    return !episode.isOver();
  }

 private:
  std::vector<AgentAction> actions_;
};

/// Walks to the end of the tick.
bool walkTick(crowd::Episode& episode, Decider& decider) {
  do {
    if (!episode.walk(decider)) return false;
  } while (!episode.beginsTick());
  return true;
}

static_assert(static_cast<int>(AgentStatus::ARRIVED) == static_cast<int>(crowd::AgentStatus::ARRIVED) &&
              static_cast<int>(AgentStatus::REMOVED) == static_cast<int>(crowd::AgentStatus::REMOVED) &&
              static_cast<int>(AgentStatus::STAYING) == static_cast<int>(crowd::AgentStatus::STAYING));

AgentState stateOf(const Agent& agent) {
  AgentState state;
  state.id = agent.id;
  state.status = static_cast<AgentStatus>(agent.status);
  state.pose = toPublic(agent.pose);
  state.velocity = toPublic(agent.velocity);
  state.max_speed = agent.max_speed;
  state.radius = agent.radius;
  state.goal = toPublic(agent.goal());
  state.in_contact = agent.in_contact;
  state.touched = agent.touched;
  state.in_collision = agent.in_collision;
  state.collided = agent.collided;
  return state;
}

RobotState stateOf(const Robot& robot) {
  RobotState state;
  state.name = robot.start.name;
  state.pose = toPublic(robot.pose);
  state.velocity = toPublic(robot.velocity);
  state.radius = robot.perceived_radius;
  if (robot.hasGoal()) state.goal = toPublic(robot.goal());
  state.arrived = robot.hasArrived();
  state.in_contact = !robot.contacts.empty();
  return state;
}

}  // namespace

struct Episode::State {
  State(const Scenario& scenario, const Vision& vision, std::uint64_t seed, std::uint64_t number, unsigned threads)
      : thread_pool(ThreadPool::countFor(threads)),
        episode(scenario.list().scene(seed, number), number, fromPublic(vision), thread_pool) {}

  const World& world() const { return episode.world(); }

  ThreadPool thread_pool;
  crowd::Episode episode;
  std::optional<CrowdDecider> decider;  // of `learner`
  const crowd::Learner* learner = nullptr;
  Perceptions perceptions;  // for decisions of the user
  std::optional<RobotSenses> senses;
};

Episode::Episode(const Scenario& scenario, const Vision& vision, std::uint64_t seed, std::uint64_t number,
                 unsigned threads)
    : state_(std::make_unique<State>(scenario, vision, seed, number, threads)) {}
Episode::Episode(Episode&&) noexcept = default;
Episode& Episode::operator=(Episode&&) noexcept = default;
Episode::~Episode() = default;

bool Episode::walk(Learner& learner) {
  if (&learner.learner() != state_->learner) {
    state_->decider.emplace(learner.learner(), state_->thread_pool);
    state_->learner = &learner.learner();
  }
  return walkTick(state_->episode, *state_->decider);
}

bool Episode::walk(const Decide& decide) {
  OwnDecider decider(decide, state_->perceptions);
  return walkTick(state_->episode, decider);
}

bool Episode::walk(const std::vector<Action>& actions) {
  GivenActions decider(actions);
  return walkTick(state_->episode, decider);
}

bool Episode::isOver() const { return state_->episode.isOver(); }
std::uint64_t Episode::tick() const { return state_->world().tick(); }
double Episode::time() const { return state_->world().time(); }
double Episode::tickDuration() const { return state_->world().tickDuration(); }

std::vector<AgentState> Episode::agents() const {
  std::vector<AgentState> states;
  states.reserve(state_->world().agents().size());
  for (const Agent& agent : state_->world().agents()) states.push_back(stateOf(agent));
  return states;
}

void Episode::agents(AgentArrays& arrays) const { toPublic(state_->world(), arrays); }

std::vector<RobotState> Episode::robots() const {
  std::vector<RobotState> states;
  for (const Robot& robot : state_->world().robots()) states.push_back(stateOf(robot));
  return states;
}

RobotScan Episode::scan(std::uint32_t robot) {
  const World& world = state_->world();
  if (robot >= world.robots().size()) throw InputError("robot: there is no robot " + std::to_string(robot));
  if (!state_->senses) state_->senses.emplace(state_->episode.scene());
  state_->senses->forgetScans();  // the world may have been edited in this tick
  const ScanSpec& spec = world.robots()[robot].start.scan;
  return {spec.first_angle, angleIncrement(spec), state_->senses->ranges(world, robot)};
}

std::map<std::size_t, Wall> Episode::walls() const {
  const Walls& walls = state_->world().walls();
  std::map<std::size_t, Wall> by_id;
  for (std::size_t i = 0; i < walls.ids().size(); ++i) by_id.emplace(walls.ids()[i], toPublic(walls.list()[i]));
  return by_id;
}

EpisodeResult Episode::result() const { return toPublic(state_->episode.result()); }

AgentId Episode::spawnAgent(const AgentStart& start) {
  crowd::AgentStart added;
  added.position = fromPublic(start.position);
  added.heading = start.heading;
  for (const Vector2& goal : start.goals) added.goals.push_back(fromPublic(goal));
  added.max_speed = start.max_speed;
  added.radius = start.radius;
  return state_->episode.edit().addAgent(added);
}

void Episode::removeAgent(AgentId agent) { state_->episode.edit().removeAgent(agent); }
void Episode::setGoal(AgentId agent, const Vector2& goal) { state_->episode.edit().setGoal(agent, fromPublic(goal)); }
void Episode::teleport(AgentId agent, const Pose& pose) { state_->episode.edit().teleport(agent, fromPublic(pose)); }
std::size_t Episode::addWall(const Wall& wall) { return state_->episode.edit().addWall(fromPublic(wall)); }
void Episode::removeWall(std::size_t wall) { state_->episode.edit().removeWall(wall); }

crowd::Episode& Episode::episode() { return state_->episode; }

void Episode::commandRobot(std::uint32_t robot, const Vector2& velocity, double rotation) {
  state_->episode.robots().command(robot, {fromPublic(velocity), rotation});
}

void Episode::teleportRobot(std::uint32_t robot, const Pose& pose) {
  state_->episode.edit().teleportRobot(robot, fromPublic(pose));
}

}  // namespace crowd::library
