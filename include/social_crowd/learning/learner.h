#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "social_crowd/avoidance/decision_context.h"
#include "social_crowd/common/random.h"
#include "social_crowd/common/static_vector.h"
#include "social_crowd/learning/agent_places.h"
#include "social_crowd/learning/model.h"
#include "social_crowd/learning/rl/learning_parameters.h"
#include "social_crowd/learning/rl/q_learner.h"
#include "social_crowd/learning/rl/q_table.h"
#include "social_crowd/world/perception.h"
#include "social_crowd/world/relative_action.h"

namespace crowd {

/// @brief training: learn and explore; demo: act greedily, tables do not change.
enum class Mode { TRAINING, DEMO };
/// @brief shared: all agents learn in one table; own: each agent learns in a copy of its own.
enum class TableUse { SHARED, OWN };
/// @brief How a table is combined with the table that an agent already has.
enum class TakeMethod { REPLACE, MERGE };

/// @brief Parse the names used in files, parameters and messages. @throws InputError that lists the valid names.
Mode parseMode(const std::string& text);
TableUse parseTableUse(const std::string& text);
TakeMethod parseTakeMethod(const std::string& text);
/// @brief Return the names that the functions above parse.
std::string toText(Mode mode);
std::string toText(TableUse use);
std::string toText(TakeMethod method);

/// @brief Decides for one or more agents and learns: receives perceptions, returns relative actions. Headless runs and
/// the ROS node use the same code.
///
/// A decision depends only on the agent's own perceptions, its table and (seed, episode, tick, agent), not on the other
/// agents that the learner serves.
///
/// Call contract: decide() is called once per tick, in sequential order once per turn. A gap in the ticks or a new
/// episode is allowed; nothing is learned across it. Not thread-safe, except that decideGreedily() and greedyChoice()
/// may run concurrently with each other (not with other functions), each thread with a workspace of its own.
class Learner {
 public:
  struct Options {
    Mode mode = Mode::DEMO;
    TableUse tables = TableUse::SHARED;
    std::uint64_t seed = 0;
    LearningPlan plan;
    std::set<AgentId> agents;  ///< the agents that it serves; empty: all agents
  };

  /// @brief Begins with an empty table. @throws InputError if the learning parameters are invalid
  Learner(Model model, Options options);
  /// @brief Begins with a table. @throws ShapeError if its shape differs from the model's; InputError as above
  Learner(Model model, Options options, QTable table);

  // Copies would write to the same table.
  Learner(const Learner&) = delete;
  Learner& operator=(const Learner&) = delete;
  Learner(Learner&&) = default;
  Learner& operator=(Learner&&) = default;
  ~Learner() = default;

  /// @brief In training mode, learns from the outcome of the last decisions. Then decides for every served agent that
  /// has not arrived, unless the episode is over (perceptions.last). `actions` is overwritten, and its capacity is
  /// reused.
  void decide(const Perceptions& perceptions, RelativeActions& actions);

  /// @brief Buffers for decisions on one thread.
  struct DecisionWorkspace {
    std::vector<Row> rows;
    std::vector<MoveBlock> moves;
    StaticVector<DecisionContext, MAX_BATCH> group;  // agents whose decisions are computed together
    std::array<std::size_t, MAX_BATCH> answers{};    // indices of their answers
  };
  /// @brief Decides greedily for every served agent that has not arrived, with the present tables, as decide() does in
  /// demo mode, but without recording new agents. May run on any number of threads, each with a workspace of its own.
  /// @param actions the decisions are appended; undefined after an exception
  void decideGreedily(const Perceptions& perceptions, DecisionWorkspace& workspace,
                      std::vector<AgentAction>& actions) const;

  /// @brief A decision and the row of the Q-table that it is based on.
  struct Choice {
    Row row = 0;
    Action action = 0;
  };
  /// @brief Returns the decision of one agent in demo mode, the same as that of decideGreedily().
  /// @param index of an agent in perceptions.agents that has not arrived
  Choice greedyChoice(const Perceptions& perceptions, std::size_t index, DecisionWorkspace& workspace) const;

  const Model& model() const { return model_; }
  bool serves(AgentId agent) const { return options_.agents.empty() || options_.agents.count(agent) > 0; }
  bool servesAll() const { return options_.agents.empty(); }
  /// @brief Returns the served agents, sorted by id; if it serves all agents, those known so far.
  std::vector<AgentId> servedAgents() const;

  Mode mode() const { return options_.mode; }
  /// @brief Changes the mode; a change discards the recorded decisions.
  void setMode(Mode mode);
  TableUse tableUse() const { return options_.tables; }

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

  /// @brief The table that an agent uses; for an unknown agent, the table that it would begin with.
  const QTable& tableOf(AgentId agent) const;
  /// @brief Returns a copy of that table for other agents. Its experience is recognised when it is merged later.
  QTable tableToShare(AgentId agent);
  /// @brief Returns a copy of that table for a file. Its experience is recognised, too. The copy depends only on the
  /// table, so that the same training gives the same file.
  QTable tableToSave(AgentId agent);

  /// @brief Result of takeTable() for one table.
  struct Taken {
    std::uint64_t new_visits = 0;  ///< visits that the agent's table did not have before
    std::uint64_t visits = 0;      ///< visits that it has now
  };
  /// @brief Result of takeTable() for all agents.
  struct TakenByAll {
    Taken newcomers;                    ///< for unknown agents; with shared tables for all agents
    std::map<AgentId, Taken> by_agent;  ///< for known agents, with own tables
  };
  /// @brief Gives a table to all present and future agents. @throws ShapeError; nothing has changed then
  TakenByAll takeTable(QTable table, TakeMethod method);
  /// @brief Gives a table to one agent; with shared tables, to all agents. @throws ShapeError; nothing has changed then
  Taken takeTable(AgentId agent, QTable table, TakeMethod method);
  /// @brief Replaces the tables of all agents, as if this learner had learned the whole table. @throws ShapeError
  void goOnIn(QTable table);

  /// @brief Discards the recorded decisions and traces, so that nothing is learned across an interruption.
  void forgetDecisions();

 private:
  using TablePointer = std::shared_ptr<QTable>;
  /// State of an agent that is kept between ticks.
  struct Memory {
    TablePointer table;
    QLearner learner;
    std::uint64_t episode = 0;
    std::uint64_t tick = 0;
    AgentPerception before;
  };

  /// Work to be done for an agent in the present tick.
  struct ServedAgent {
    std::uint32_t place;       // index of its memory; NOBODY: it is not served
    std::uint32_t answer;      // index of its answer; NOBODY: it gets none
    std::uint32_t neighbours;  // number of its neighbours within the model's vision
  };
  static constexpr std::uint32_t NOBODY = UINT32_MAX;
  /// Returns the index of the agent's memory; creates it for a new agent.
  std::uint32_t placeOf(AgentId agent) {
    const std::uint32_t known = places_.find(agent);
    return known != AgentPlaces::NONE ? known : addMemory(agent);
  }
  std::uint32_t addMemory(AgentId agent);
  /// Returns the table to write to; copies it first if other agents use it, too (copy on write).
  QTable& writable(Memory& memory) {
    if (options_.tables == TableUse::OWN && memory.table.use_count() > 1) copyTable(memory);
    return *memory.table;
  }
  static void copyTable(Memory& memory);
  void checkShape(const QTable& table) const;
  /// Separates what is learned from now on from the previous contents of the tables.
  void beginSources();
  /// Names the own source of an agent's table.
  void nameSource(AgentId agent, SourceId name);
  static Taken give(TablePointer& place, const QTable& table, TakeMethod method);
  void beginEpisode(std::uint64_t episode);
  void listServedAgents(const Perceptions& perceptions, RelativeActions& actions);
  /// Returns the number of neighbours in a perception that are within the model's vision.
  std::uint32_t neighboursInSight(const Perceptions& perceptions, const AgentPerception& self) const;
  /// Returns the perception of an agent, limited to the model's vision: messages may contain more neighbours.
  static Perception perceptionOf(const Perceptions& perceptions, std::size_t index, std::uint32_t neighbours) {
    Perception seen(perceptions, index);
    seen.neighbours = seen.neighbours.front(neighbours);
    return seen;
  }
  Perception perceptionOf(const Perceptions& perceptions, std::size_t index) const {
    return perceptionOf(perceptions, index, served_agents_[index].neighbours);
  }
  void makeRoom(std::size_t choices, DecisionWorkspace& workspace) const;
  DecisionContext contextAt(std::size_t place, const Perception& seen, DecisionWorkspace& workspace) const;
  void findRows(const DecisionContext& context) const;
  void findRowsOfGroup(const DecisionWorkspace& workspace) const;
  Rows rowsOf(const DecisionContext& context) const { return {context.rows, stride_ == 1 ? 0U : 1U}; }
  /// Calls work(index) for all agents that get an answer.
  template <typename Work>
  void forEachServedAgent(const Perceptions& perceptions, const Work& work) const;
  void learn(const Perceptions& perceptions);
  void findAllRows(const Perceptions& perceptions);
  void learnOne(const Perception& seen, const Perceptions& perceptions, const Rows& rows, Memory& memory);
  void exploreAll(const Perceptions& perceptions, RelativeActions& actions);
  void chooseGreedily(const Perceptions& perceptions, RelativeActions& actions);
  /// learn() and exploreAll() for a single agent, without intermediate storage.
  void learnAndChoose(const Perceptions& perceptions, RelativeActions& actions);
  /// Adds an agent to the group; computes the decisions of the group when it is full.
  /// @param answer index of its decision in the actions
  void joinGreedily(const Perceptions& perceptions, const Perception& seen, std::size_t answer,
                    DecisionWorkspace& workspace, std::vector<AgentAction>& actions) const;
  /// Computes the decisions of the group and empties it.
  void answerGreedily(const Perceptions& perceptions, DecisionWorkspace& workspace,
                      std::vector<AgentAction>& actions) const;
  /// Returns the number that decides among equal values: that of the first, or a random number of the agent.
  double tieOf(const Perceptions& perceptions, AgentId agent) const;
  /// @param chance random numbers of the tick
  Action chooseExploring(const KeyedRandom& chance, const Perceptions& perceptions, const AgentPerception& self,
                         const Rows& rows, Memory& memory) const;
  /// Writes the relative action of an action to `given`.
  void answer(const DecisionContext& context, Action action, AgentAction& given) const;

  Model model_;
  Vision sight_;              // limits of the perception, see StateSet::maxNeighbours()
  std::size_t stride_;        // rows per perception
  std::size_t moves_stride_;  // blocks of moves per agent; 0 if the state set does not need them
  Options options_;
  LearningParameters parameters_;
  LearningRateSchedule learning_rates_;
  Mirror mirror_;
  EpsilonSchedule epsilon_;
  std::uint64_t episode_ = 0;
  KeyedRandom chance_;  // random numbers of the episode
  bool began_ = false;
  std::uint64_t decisions_ = 0;
  bool has_own_sources_ = false;  // whether learning began a source of its own
  TablePointer base_;             // table of all agents (shared), or of new agents (own)
  AgentPlaces places_;            // indices of memories_
  std::vector<Memory> memories_;
  std::vector<ServedAgent> served_agents_;  // buffer, all agents of a tick
  DecisionWorkspace workspace_;             // buffer, all agents of a tick while learning
};

}  // namespace crowd
