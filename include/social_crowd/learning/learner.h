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

/// @brief training: learns and explores; demo: greedy, the table stays as it is.
enum class Mode { TRAINING, DEMO };
/// @brief shared: all agents learn in one table; own: each goes on in a copy of its own.
enum class TableUse { SHARED, OWN };
/// @brief What becomes of the table an agent has when it is given another one.
enum class TakeMethod { REPLACE, MERGE };

/// @brief The names used in files, parameters and messages. @throws InputError naming what was expected.
Mode parseMode(const std::string& text);
TableUse parseTableUse(const std::string& text);
TakeMethod parseTakeMethod(const std::string& text);
std::string toText(Mode mode);
std::string toText(TableUse use);
std::string toText(TakeMethod method);

/// @brief Decides for one agent or many, and learns: perceptions in, relative actions out. The same code serves the
/// headless runs and the ROS node.
///
/// What an agent decides depends on its own perceptions, its table and (seed, episode, tick, agent) alone, not on which
/// other agents the same learner serves.
class Learner {
 public:
  struct Options {
    Mode mode = Mode::DEMO;
    TableUse tables = TableUse::SHARED;
    std::uint64_t seed = 0;
    LearningPlan plan;
    std::set<AgentId> agents;  ///< whom it serves; empty: everybody
  };

  /// @brief With an empty table. @throws InputError if the learning parameters are wrong.
  Learner(Model model, Options options);
  /// @brief With a table. @throws ShapeError if it has not the model's shape.
  Learner(Model model, Options options, QTable table);

  // Copies would go on writing into one and the same table.
  Learner(const Learner&) = delete;
  Learner& operator=(const Learner&) = delete;
  Learner(Learner&&) = default;
  Learner& operator=(Learner&&) = default;
  ~Learner() = default;

  /// @brief Learns from what the last decisions led to (training mode), then decides for every served agent that is on
  /// its way, unless the episode is over. `actions` is overwritten.
  void decide(const Perceptions& perceptions, RelativeActions& actions);

  /// @brief Working space of one thread that decides.
  struct DecisionWorkspace {
    std::vector<Row> rows;
    std::vector<MoveBlock> moves;
    StaticVector<DecisionContext, MAX_BATCH> group;  // those that choose side by side
    std::array<std::size_t, MAX_BATCH> answers{};    // places of their decisions
  };
  /// @brief Decides greedily for everybody served that is on its way, with the tables as they are: what decide() does
  /// in demo mode, but nothing is kept of whom it did not know before. Any number of threads may do that, each with
  /// working space of its own.
  /// @param actions decisions are added behind those that are there; after an exception they mean nothing
  void decideGreedily(const Perceptions& perceptions, DecisionWorkspace& workspace,
                      std::vector<AgentAction>& actions) const;

  /// @brief A decision, and the row of the Q-table that its action was looked up in.
  struct Choice {
    Row row = 0;
    Action action = 0;
  };
  /// @brief What the agent at that index decides in demo mode; decideGreedily() decides the same.
  Choice greedyChoice(const Perceptions& perceptions, std::size_t index, DecisionWorkspace& workspace) const;

  const Model& model() const { return model_; }
  bool serves(AgentId agent) const { return options_.agents.empty() || options_.agents.count(agent) > 0; }
  bool servesAll() const { return options_.agents.empty(); }
  /// @brief The agents it serves, in order; if it serves all, those met so far.
  std::vector<AgentId> servedAgents() const;

  Mode mode() const { return options_.mode; }
  void setMode(Mode mode);
  TableUse tableUse() const { return options_.tables; }

  /// @brief What is in force now; epsilon as of the last episode seen.
  const LearningParameters& parameters() const { return parameters_; }
  /// @brief The same with the schedule of epsilon.
  LearningPlan plan() const { return {parameters_, epsilon_}; }
  /// @brief Takes effect at once; epsilon is what the schedule says of the present episode. @throws InputError
  void setPlan(const LearningPlan& plan);

  std::uint64_t seed() const { return options_.seed; }
  /// @brief Decisions that were learned from, those of the loaded table included.
  std::uint64_t decisions() const { return decisions_; }
  void setDecisions(std::uint64_t decisions) { decisions_ = decisions; }

  /// @brief The table an agent uses; that of agents not yet known where it is unknown.
  const QTable& tableOf(AgentId agent) const;
  /// @brief A copy of it for other agents. What it holds is recognised later as what this agent had learned.
  QTable tableToShare(AgentId agent);
  /// @brief A copy of it for a file, which is recognised as well. Depends on nothing but the table, so that the same
  /// training gives the same file.
  QTable tableToSave(AgentId agent);

  /// @brief What became of a table that was given.
  struct Taken {
    std::uint64_t new_visits = 0;  ///< that the agent's table did not have before
    std::uint64_t visits = 0;      ///< that it has now
  };
  struct TakenByAll {
    Taken newcomers;                    ///< agents not met yet; with a shared table everybody
    std::map<AgentId, Taken> by_agent;  ///< with own tables
  };
  /// @brief Gives a table to everybody, now and later. @throws ShapeError, nothing has changed then.
  TakenByAll takeTable(QTable table, TakeMethod method);
  /// @brief Gives a table to one agent; with shared tables that is everybody. @throws ShapeError
  Taken takeTable(AgentId agent, QTable table, TakeMethod method);
  /// @brief Everybody goes on learning in this table as if all of it had been learned here. @throws ShapeError
  void goOnIn(QTable table);

  /// @brief Forgets what was decided last, so that nothing is learned across the gap.
  void forgetDecisions();

 private:
  using TablePointer = std::shared_ptr<QTable>;
  /// What is kept of an agent from tick to tick.
  struct Memory {
    TablePointer table;
    QLearner learner;
    std::uint64_t episode = 0;
    std::uint64_t tick = 0;
    AgentPerception before;
  };

  /// What is to be done about an agent of the present tick.
  struct ServedAgent {
    std::uint32_t place;       // of its memory; NOBODY: it is not served
    std::uint32_t answer;      // place among the answers; NOBODY: it has arrived
    std::uint32_t neighbours;  // so many of its neighbours are within sight
  };
  static constexpr std::uint32_t NOBODY = UINT32_MAX;
  /// Of its memory; a new one if the agent was not met before.
  std::uint32_t placeOf(AgentId agent) {
    const std::uint32_t known = places_.find(agent);
    return known != AgentPlaces::NONE ? known : addMemory(agent);
  }
  std::uint32_t addMemory(AgentId agent);
  /// The table to write into; a copy is made first where others still read it.
  QTable& writable(Memory& memory) {
    if (options_.tables == TableUse::OWN && memory.table.use_count() > 1) copyTable(memory);
    return *memory.table;
  }
  static void copyTable(Memory& memory);
  void checkShape(const QTable& table) const;
  /// From now on what is learned is told from what the tables held before.
  void beginSources();
  /// Names the own source of the agent's table.
  void nameSource(AgentId agent, SourceId name);
  static Taken give(TablePointer& place, const QTable& table, TakeMethod method);
  void beginEpisode(std::uint64_t episode);
  void listServedAgents(const Perceptions& perceptions, RelativeActions& actions);
  /// How many of the bodies that an agent was told of are within the model's vision.
  std::uint32_t neighboursInSight(const Perceptions& perceptions, const AgentPerception& self) const;
  /// What an agent perceives, of that no more than the model's vision: others may have been told more.
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
  /// Calls work(index) for all agents that are to answer.
  template <typename Work>
  void forEachServedAgent(const Perceptions& perceptions, const Work& work) const;
  void learn(const Perceptions& perceptions);
  void findAllRows(const Perceptions& perceptions);
  void learnOne(const Perception& seen, const Perceptions& perceptions, const Rows& rows, Memory& memory);
  void exploreAll(const Perceptions& perceptions, RelativeActions& actions);
  void chooseGreedily(const Perceptions& perceptions, RelativeActions& actions);
  /// learn() and exploreAll() for one agent alone: nothing need be kept between the two.
  void learnAndChoose(const Perceptions& perceptions, RelativeActions& actions);
  /// Adds an agent to the group, which decides as soon as it is full.
  /// @param answer place of its decision among the actions
  void joinGreedily(const Perceptions& perceptions, const Perception& seen, std::size_t answer,
                    DecisionWorkspace& workspace, std::vector<AgentAction>& actions) const;
  /// Decides for the group, which is empty then.
  void answerGreedily(const Perceptions& perceptions, DecisionWorkspace& workspace,
                      std::vector<AgentAction>& actions) const;
  /// What decides between equal values: the first, or a draw of the agent's own.
  double tieOf(const Perceptions& perceptions, AgentId agent) const;
  /// @param chance that of the tick
  Action chooseExploring(const KeyedRandom& chance, const Perceptions& perceptions, const AgentPerception& self,
                         const Rows& rows, Memory& memory) const;
  /// Writes to `given` what the action means to the agent.
  void answer(const DecisionContext& context, Action action, AgentAction& given) const;

  Model model_;
  Vision sight_;              // all that the state set looks at
  std::size_t stride_;        // rows of a perception
  std::size_t moves_stride_;  // blocks of moves that the state set looks at
  Options options_;
  LearningParameters parameters_;
  LearningRateSchedule learning_rates_;
  Mirror mirror_;
  EpsilonSchedule epsilon_;
  std::uint64_t episode_ = 0;
  KeyedRandom chance_;  // of the episode
  bool began_ = false;
  std::uint64_t decisions_ = 0;
  bool has_own_sources_ = false;  // what was learned here is told from what was given
  TablePointer base_;             // of everybody (shared), or what newcomers begin with (own)
  AgentPlaces places_;            // of memories
  std::vector<Memory> memories_;
  std::vector<ServedAgent> served_agents_;  // scratch, of all agents of a tick
  DecisionWorkspace workspace_;             // scratch, of all agents of a tick while learning
};

}  // namespace crowd
