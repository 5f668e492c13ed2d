#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "avoidance/perception_batch.h"
#include "common/random.h"
#include "common/text/enum_names.h"
#include "common/thread_pool.h"
#include "learning/agent_share.h"
#include "learning/agent_tables.h"
#include "learning/decision_values.h"
#include "learning/model.h"
#include "learning/rl/learning_parameters.h"
#include "learning/rl/policy.h"
#include "learning/rl/td_learner.h"
#include "world/agent_map.h"
#include "world/perception.h"
#include "world/relative_action.h"

namespace crowd {

/// @brief training: learn and explore; demo: act greedily, tables do not change.
enum class Mode { TRAINING, DEMO };

inline constexpr EnumNames<Mode, 2> MODES{"mode", {"training", "demo"}};

/// @brief A decision: the chosen action and the row of the Q-table that its value is in.
struct Choice {
  Row row = 0;
  Action action = 0;
};

/// @brief Buffers for the decisions of one thread, for any learners, one after the other.
struct DecisionWorkspace {
  std::vector<Perception> seen;               ///< of the served agents, limited to the model's vision
  std::vector<std::uint32_t> places;          ///< of these agents
  std::vector<MoveBlock> moves;               ///< candidate moves of each of these agents
  std::vector<BrakingLimits> limits;          ///< of the moves, one list per agent
  std::vector<Row> rows;                      ///< of each of these agents
  std::vector<Choice> choices;                ///< the decision behind each answer of the last call
  std::shared_ptr<const ActionSet> moves_of;  ///< the action set that wrote `moves`
};

/// @brief Decides for one or more agents and learns: receives perceptions, returns relative actions. Headless runs and
/// the ROS node use the same code.
///
/// Combines a model, the tables of the agents (AgentTables), the policy (policy.h) and one TdLearner per agent. A
/// decision is made in stages, each for a batch of agents: limit the perceptions to the model's vision; find the
/// candidate moves and the rows; in training mode, learn from the outcome of the last decisions; choose; answer.
///
/// A decision depends only on the agent's own perceptions, its table and (seed, episode, tick, agent), not on the other
/// agents that the learner serves.
///
/// Call contract: decide() is called once per tick, in sequential order once per turn. A gap in the ticks or a new
/// episode is allowed; nothing is learned across it. Not thread-safe, except that decideGreedily() may run concurrently
/// with itself (not with other functions), each thread with a workspace of its own.
class Learner {
 public:
  struct Options {
    Mode mode = Mode::DEMO;
    TableUse tables = TableUse::SHARED;
    std::uint64_t seed = 0;
    LearningPlan plan;
    std::set<AgentId> agents;  ///< the agents that it serves; empty: all agents, or its share of them
    AgentShare share;          ///< if no agents are listed
  };

  /// @brief Begins with an empty table. @throws InputError if the learning parameters are invalid
  Learner(Model model, Options options);
  /// @brief Begins with a table. @throws ShapeError if its shape differs from the model's; InputError as above
  Learner(Model model, Options options, QTable table);

  /// @brief In training mode, learns from the outcome of the last decisions. Then decides for every served agent that
  /// has not arrived, unless the episode is over (perceptions.last). `actions` is overwritten, and its capacity is
  /// reused.
  /// @param thread_pool its threads share the decisions of demo mode, which do not depend on their number
  void decide(const Perceptions& perceptions, RelativeActions& actions,
              ThreadPool& thread_pool = ThreadPool::callerOnly());

  /// @brief Decides as decide() does in demo mode, without recording new agents.
  /// @param actions the decisions are appended; undefined after an exception
  void decideGreedily(const Perceptions& perceptions, DecisionWorkspace& workspace,
                      std::vector<AgentAction>& actions) const;

  /// @brief Returns what an agent chose from in the last call of decide(), for display. The values are those of the
  /// decision until the next call of a function that changes a table.
  /// @param perceptions, actions those of that call
  /// @return null if the agent did not decide
  std::optional<DecisionValues> valuesOf(const Perceptions& perceptions, const RelativeActions& actions,
                                         AgentId agent) const;

  const Model& model() const { return model_; }
  bool serves(AgentId agent) const {
    return options_.agents.empty() ? options_.share.contains(agent) : options_.agents.count(agent) > 0;
  }
  bool servesAll() const { return options_.agents.empty() && options_.share.isWhole(); }
  const AgentShare& share() const { return options_.share; }
  /// @brief Returns the served agents, sorted by id; if it serves all agents or a share of them, those known so far.
  /// With shared tables, it forgets those that are not perceived any more as soon as there are many.
  std::vector<AgentId> servedAgents() const;

  Mode mode() const { return options_.mode; }
  /// @brief Changes the mode; a change discards the recorded decisions.
  void setMode(Mode mode);

  /// @brief The present parameters; epsilon is that of the present episode.
  const LearningParameters& parameters() const { return parameters_; }
  /// @brief Returns the present parameters with the schedule of epsilon.
  LearningPlan plan() const { return {parameters_, epsilon_}; }
  /// @brief Changes the parameters immediately; epsilon becomes the schedule's value for the present episode.
  /// @throws InputError if a parameter is invalid; nothing has changed then
  void setPlan(const LearningPlan& plan);

  std::uint64_t seed() const { return options_.seed; }
  /// @brief Number of decisions that were learned from, including those of setDecisions().
  std::uint64_t decisions() const { return decisions_; }
  /// @brief Sets that number, such as to the number of a loaded table.
  void setDecisions(std::uint64_t decisions) { decisions_ = decisions; }
  /// @brief Sum of the rewards of the decisions of the present episode that were learned from.
  double episodeReward() const { return episode_reward_; }

  /// @brief The tables of the agents, to share, save and replace them.
  AgentTables& tables() { return tables_; }
  const AgentTables& tables() const { return tables_; }

  /// @brief Discards the recorded decisions and traces, so that nothing is learned across an interruption.
  void forgetDecisions();

 private:
  /// What an agent's next update needs.
  struct Memory {
    TdLearner learner;
    std::uint64_t episode = 0;  // of its last decision
    std::uint64_t tick = 0;
    AgentPerception before;
  };

  /// The decisions for some agents, made by one thread.
  struct Part {
    std::vector<AgentAction> actions;
    std::vector<Choice> choices;
  };

  /// Adds an agent unless it is known. Returns its place.
  std::uint32_t addAgent(AgentId agent);
  /// Forgets agents that have left, if many agents are known. An agent with a table of its own keeps it.
  void forgetDeparted(const Perceptions& perceptions);
  void beginEpisode(std::uint64_t episode);

  void limit(Perception& seen) const;
  template <typename PlaceOf>
  void perceive(const Perceptions& perceptions, std::size_t first, std::size_t last, const PlaceOf& place_of,
                DecisionWorkspace& workspace) const;
  void decideSome(const Perceptions& perceptions, std::size_t begin, std::size_t end, DecisionWorkspace& workspace,
                  std::vector<AgentAction>& actions) const;
  /// Decides for all agents in demo mode, in parts that threads share.
  void decideInParts(const Perceptions& perceptions, std::vector<AgentAction>& actions, ThreadPool& thread_pool);
  void findRows(DecisionWorkspace& workspace) const;
  void learn(const Perceptions& perceptions);
  void learnOne(const Perception& seen, const Perceptions& perceptions, const Rows& rows, std::uint32_t place);
  /// Calls choose(k) for each agent of the workspace that has not arrived, and appends its answer.
  template <typename Choose>
  void answer(DecisionWorkspace& workspace, std::vector<AgentAction>& actions, const Choose& choose) const;
  Action explore(const KeyedRandom& chance, const Perceptions& perceptions, std::size_t k);
  Rows rowsOf(const DecisionWorkspace& workspace, std::size_t k) const {
    return {&workspace.rows[k * rows_each_], rows_each_ == 1 ? 0U : 1U};
  }
  /// Returns the number that decides among equal values: that of the first, or a random number of the agent.
  double tieOf(const Perceptions& perceptions, AgentId agent) const;

  Model model_;
  Vision vision_;            // of the state set, without a margin
  std::size_t rows_each_;    // rows per agent
  std::size_t blocks_each_;  // blocks of moves per agent
  bool has_constant_moves_;  // the moves in a workspace stay valid
  Options options_;
  std::shared_ptr<const ActionSet> actions_;  // that agents use in the present mode
  LearningParameters parameters_;
  LearningRateSchedule learning_rates_;
  Mirror mirror_;
  EpsilonSchedule epsilon_;
  std::uint64_t episode_ = 0;
  KeyedRandom chance_;  // random numbers of the episode
  bool began_ = false;
  std::uint64_t decisions_ = 0;
  double episode_reward_ = 0.0;
  AgentTables tables_;
  std::vector<Memory> memories_;         // by place
  std::size_t most_known_ = FEW_AGENTS;  // with more, forgetDeparted() looks for agents that have left
  DecisionWorkspace workspace_;
  std::vector<Part> parts_;
  std::vector<DecisionWorkspace> workspaces_;  // of the threads that decide in parts
};

}  // namespace crowd
