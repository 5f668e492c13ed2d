#include "social_crowd/learning/learner.h"

#include <algorithm>
#include <array>

#include "social_crowd/common/prefetch.h"

namespace crowd {
namespace {

[[noreturn]] void throwUnknownName(const std::string& what, const std::string& expected, const std::string& got) {
  throw InputError(what + ": expected " + expected + ", got '" + got + "'");
}

Mirror mirrorFor(const Model& model, const LearningParameters& parameters) {
  return parameters.mirrored ? Mirror(*model.state_set, *model.action_set) : Mirror();
}

}  // namespace

Mode parseMode(const std::string& text) {
  if (text == "training") return Mode::TRAINING;
  if (text == "demo") return Mode::DEMO;
  throwUnknownName("mode", "training or demo", text);
}

TableUse parseTableUse(const std::string& text) {
  if (text == "shared") return TableUse::SHARED;
  if (text == "own") return TableUse::OWN;
  throwUnknownName("tables", "shared or own", text);
}

TakeMethod parseTakeMethod(const std::string& text) {
  if (text == "replace") return TakeMethod::REPLACE;
  if (text == "merge") return TakeMethod::MERGE;
  throwUnknownName("method", "replace or merge", text);
}

std::string toText(Mode mode) { return mode == Mode::TRAINING ? "training" : "demo"; }
std::string toText(TableUse use) { return use == TableUse::SHARED ? "shared" : "own"; }
std::string toText(TakeMethod method) { return method == TakeMethod::REPLACE ? "replace" : "merge"; }

Learner::Learner(Model model, Options options)
    : Learner(model, std::move(options), QTable(model.state_set->rowCount(), model.action_set->size())) {}

Learner::Learner(Model model, Options options, QTable table)
    : model_(std::move(model)),
      sight_{model_.state_set->distanceLimits().back(), model_.state_set->maxNeighbours()},
      stride_(model_.state_set->rowsPerPerception()),
      moves_stride_(model_.state_set->needsMoves() ? blocksOf(model_.action_set->size()) : 0),
      options_(std::move(options)),
      parameters_(options_.plan.parameters),
      learning_rates_(parameters_),
      mirror_(mirrorFor(model_, parameters_)),
      epsilon_(options_.plan.epsilon),
      chance_(options_.seed, KeyedRandom::EXPLORATION, {episode_}),
      base_(std::make_shared<QTable>(std::move(table))) {
  const std::string problems = parameters_.problems();
  if (!problems.empty()) throw InputError(problems);
  checkShape(*base_);
  if (options_.mode == Mode::TRAINING) beginSources();
}

void Learner::beginSources() {
  if (has_own_sources_) return;
  base_->beginSource();  // no agent has a table of its own yet
  has_own_sources_ = true;
}

void Learner::checkShape(const QTable& table) const {
  const Row rows = model_.state_set->rowCount();
  const Action actions = model_.action_set->size();
  if (table.rows() == rows && table.actions() == actions) return;
  throw ShapeError("expected a Q-table of " + std::to_string(rows) + " rows and " + std::to_string(actions) +
                   " actions, got " + std::to_string(table.rows()) + " and " + std::to_string(table.actions()));
}

void Learner::decide(const Perceptions& perceptions, RelativeActions& actions) {
  if (!began_ || perceptions.episode != episode_) beginEpisode(perceptions.episode);
  actions.episode = perceptions.episode;
  actions.tick = perceptions.tick;
  if (perceptions.agents.size() == 1 && options_.mode == Mode::TRAINING && servesAll()) {
    return learnAndChoose(perceptions, actions);
  }
  listServedAgents(perceptions, actions);
  if (options_.mode == Mode::TRAINING) {
    // All agents learn before any agent decides, so that all decisions of a tick use the same table.
    learn(perceptions);
    if (!perceptions.last) exploreAll(perceptions, actions);
  } else if (!perceptions.last) {
    chooseGreedily(perceptions, actions);
  }
}

inline void Learner::learnAndChoose(const Perceptions& perceptions, RelativeActions& actions) {
  makeRoom(1, workspace_);
  const AgentPerception& self = perceptions.agents.front();
  Memory& memory = memories_[placeOf(self.agent)];
  const DecisionContext context =
      contextAt(0, perceptionOf(perceptions, 0, neighboursInSight(perceptions, self)), workspace_);
  if (!self.arrived) findRows(context);
  learnOne(context.seen, perceptions, rowsOf(context), memory);
  actions.agents.clear();
  if (perceptions.last || self.arrived) return;
  const KeyedRandom chance = chance_.with(perceptions.tick);
  const Action action = chooseExploring(chance, perceptions, self, rowsOf(context), memory);
  answer(context, action, actions.agents.emplace_back());
}

void Learner::decideGreedily(const Perceptions& perceptions, DecisionWorkspace& workspace,
                             std::vector<AgentAction>& actions) const {
  makeRoom(MAX_BATCH, workspace);
  workspace.group.clear();
  std::size_t answers = actions.size();
  actions.resize(answers + perceptions.agents.size());
  for (std::size_t i = 0; i < perceptions.agents.size(); ++i) {
    const AgentPerception& self = perceptions.agents[i];
    if (self.arrived || !serves(self.agent)) continue;
    const Perception seen = perceptionOf(perceptions, i, neighboursInSight(perceptions, self));
    joinGreedily(perceptions, seen, answers++, workspace, actions);
  }
  answerGreedily(perceptions, workspace, actions);
  actions.resize(answers);
}

Learner::Choice Learner::greedyChoice(const Perceptions& perceptions, std::size_t index,
                                      DecisionWorkspace& workspace) const {
  makeRoom(1, workspace);
  const AgentPerception& self = perceptions.agents[index];
  const DecisionContext context =
      contextAt(0, perceptionOf(perceptions, index, neighboursInSight(perceptions, self)), workspace);
  findRows(context);
  const double tie = tieOf(perceptions, self.agent);
  const Action action = QLearner::chooseGreedy(tableOf(self.agent), rowsOf(context), tie);
  return {rowsOf(context)[action], action};
}

inline void Learner::listServedAgents(const Perceptions& perceptions, RelativeActions& actions) {
  served_agents_.resize(perceptions.agents.size());
  ServedAgent* served_agent = served_agents_.data();
  std::uint32_t answers = 0;
  for (const AgentPerception& self : perceptions.agents) {
    const bool served = serves(self.agent);
    *served_agent++ = {served ? placeOf(self.agent) : NOBODY, served && !self.arrived ? answers++ : NOBODY,
                       neighboursInSight(perceptions, self)};
  }
  actions.agents.resize(perceptions.last ? 0 : answers);
}

template <typename Work>
inline void Learner::forEachServedAgent(const Perceptions& perceptions, const Work& work) const {
  const std::size_t size = served_agents_.size();
  if (perceptions.order.size() != size) {
    for (std::size_t index = 0; index < size; ++index) {
      if (served_agents_[index].answer != NOBODY) work(index);
    }
    return;
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (i + PREFETCH_AHEAD < size) prefetch(perceptions.agents[perceptions.order[i + PREFETCH_AHEAD]]);
    const std::size_t index = perceptions.order[i];
    if (served_agents_[index].answer != NOBODY) work(index);
  }
}

void Learner::beginEpisode(std::uint64_t episode) {
  began_ = true;
  episode_ = episode;
  chance_ = KeyedRandom(options_.seed, KeyedRandom::EXPLORATION, {episode});
  parameters_.epsilon = epsilon_.at(episode);
  forgetDecisions();
}

inline std::uint32_t Learner::neighboursInSight(const Perceptions& perceptions, const AgentPerception& self) const {
  // Without a limit the state set selects the neighbours itself.
  if (sight_.max_neighbours == 0) return self.neighbour_count;
  std::uint32_t count = std::min(sight_.max_neighbours, self.neighbour_count);
  // Neighbours are sorted, nearest rim first.
  while (count > 0 && rimDistance(perceptions.neighbours[self.first_neighbour + count - 1]) > sight_.radius) --count;
  return count;
}

inline void Learner::makeRoom(std::size_t choices, DecisionWorkspace& workspace) const {
  if (workspace.rows.size() >= choices * stride_) return;
  workspace.rows.resize(choices * stride_);
  workspace.moves.resize(choices * moves_stride_);
}

inline DecisionContext Learner::contextAt(std::size_t place, const Perception& seen,
                                          DecisionWorkspace& workspace) const {
  return {seen, moves_stride_ == 0 ? nullptr : &workspace.moves[place * moves_stride_],
          &workspace.rows[place * stride_]};
}

inline void Learner::findRows(const DecisionContext& context) const {
  if (context.moves != nullptr) model_.action_set->findMoves(context);
  model_.state_set->findRows(context);
}

inline void Learner::findRowsOfGroup(const DecisionWorkspace& workspace) const {
  const DecisionBatch group(workspace.group.data(), workspace.group.size());
  if (moves_stride_ > 0) model_.action_set->findMovesOfAll(group);
  model_.state_set->findRowsOfAll(group);
}

inline void Learner::learn(const Perceptions& perceptions) {
  findAllRows(perceptions);
  const std::size_t size = served_agents_.size();
  for (std::size_t i = 0; i < size; ++i) {
    const ServedAgent served_agent = served_agents_[i];
    if (served_agent.place == NOBODY) continue;
    const DecisionContext context = contextAt(i, perceptionOf(perceptions, i), workspace_);
    learnOne(context.seen, perceptions, rowsOf(context), memories_[served_agent.place]);
  }
}

/// Finds the rows of all agents before they learn: learning does not change rows, and batches are faster.
inline void Learner::findAllRows(const Perceptions& perceptions) {
  makeRoom(served_agents_.size(), workspace_);
  workspace_.group.clear();
  const auto find = [&] {
    findRowsOfGroup(workspace_);
    workspace_.group.clear();
  };
  forEachServedAgent(perceptions, [&](std::size_t index) {
    workspace_.group.add(contextAt(index, perceptionOf(perceptions, index), workspace_));
    if (workspace_.group.isFull()) find();
  });
  find();
}

inline void Learner::learnOne(const Perception& seen, const Perceptions& perceptions, const Rows& rows,
                              Memory& memory) {
  const AgentPerception& now = seen.self;
  if (!memory.learner.hasDecision()) return;
  // Nothing is learned from a decision that was not carried out or was made before the previous tick.
  if (!now.acted || memory.episode != perceptions.episode || memory.tick + 1 != perceptions.tick) {
    memory.learner.resetTraces();
    return;
  }
  if (now.arrived) {
    memory.learner.learnTerminal(writable(memory), (*model_.reward)(memory.before, seen, 0), parameters_,
                                 learning_rates_, mirror_);
  } else {
    const double reward = (*model_.reward)(memory.before, seen, rows[0]);
    memory.learner.learn(writable(memory), reward, rows, parameters_, learning_rates_, mirror_);
    if (perceptions.last) memory.learner.resetTraces();
  }
  ++decisions_;
}

inline void Learner::exploreAll(const Perceptions& perceptions, RelativeActions& actions) {
  const KeyedRandom chance = chance_.with(perceptions.tick);
  forEachServedAgent(perceptions, [&](std::size_t index) {
    const ServedAgent served_agent = served_agents_[index];
    const DecisionContext context = contextAt(index, perceptionOf(perceptions, index), workspace_);
    const Action action =
        chooseExploring(chance, perceptions, context.seen.self, rowsOf(context), memories_[served_agent.place]);
    answer(context, action, actions.agents[served_agent.answer]);
  });
}

inline void Learner::chooseGreedily(const Perceptions& perceptions, RelativeActions& actions) {
  makeRoom(MAX_BATCH, workspace_);
  workspace_.group.clear();
  forEachServedAgent(perceptions, [&](std::size_t index) {
    joinGreedily(perceptions, perceptionOf(perceptions, index), served_agents_[index].answer, workspace_,
                 actions.agents);
  });
  answerGreedily(perceptions, workspace_, actions.agents);
}

inline double Learner::tieOf(const Perceptions& perceptions, AgentId agent) const {
  if (parameters_.ties == Ties::FIRST) return QLearner::FIRST_OF_TIES;
  return KeyedRandom(options_.seed, KeyedRandom::TIES, {perceptions.episode, perceptions.tick, agent}).uniform();
}

inline void Learner::joinGreedily(const Perceptions& perceptions, const Perception& seen, std::size_t answer,
                                  DecisionWorkspace& workspace, std::vector<AgentAction>& actions) const {
  const std::size_t place = workspace.group.size();
  workspace.group.add(contextAt(place, seen, workspace));
  workspace.answers[place] = answer;
  if (workspace.group.isFull()) answerGreedily(perceptions, workspace, actions);
}

inline void Learner::answerGreedily(const Perceptions& perceptions, DecisionWorkspace& workspace,
                                    std::vector<AgentAction>& actions) const {
  findRowsOfGroup(workspace);
  const auto& group = workspace.group;
  std::array<Action, MAX_BATCH> chosen;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  for (std::size_t k = 0; k < group.size(); ++k) {
    const AgentId agent = group[k].seen.self.agent;
    chosen[k] = QLearner::chooseGreedy(tableOf(agent), rowsOf(group[k]), tieOf(perceptions, agent));
  }
  for (std::size_t k = 0; k < group.size(); ++k) answer(group[k], chosen[k], actions[workspace.answers[k]]);
  workspace.group.clear();
}

inline Action Learner::chooseExploring(const KeyedRandom& chance, const Perceptions& perceptions,
                                       const AgentPerception& self, const Rows& rows, Memory& memory) const {
  KeyedRandom random = chance.with(self.agent);
  const double draw = random.uniform();
  const double any = random.uniform();
  const double tie = tieOf(perceptions, self.agent);
  const Action action = QLearner::chooseExploring(*memory.table, rows, parameters_.epsilon, draw, any, tie);
  memory.learner.recordDecision(*memory.table, rows, action, parameters_);
  memory.episode = perceptions.episode;
  memory.tick = perceptions.tick;
  memory.before = self;
  return action;
}

inline void Learner::answer(const DecisionContext& context, Action action, AgentAction& given) const {
  given.agent = context.seen.self.agent;
  // Writes to the destination directly: the loads of a copy would wait for the stores that were just made.
  if (context.moves == nullptr) {
    model_.action_set->findAction(context.seen, action, given.action);
  } else {
    given.action = toAction(moveAt(context.moves, action));
  }
}

std::uint32_t Learner::addMemory(AgentId agent) {
  memories_.emplace_back().table = base_;
  return places_.add(agent);
}

void Learner::copyTable(Memory& memory) { memory.table = std::make_shared<QTable>(*memory.table); }

std::vector<AgentId> Learner::servedAgents() const {
  if (!servesAll()) return {options_.agents.begin(), options_.agents.end()};
  std::vector<AgentId> known = places_.agents();
  std::sort(known.begin(), known.end());
  return known;
}

void Learner::setMode(Mode mode) {
  if (mode != options_.mode) forgetDecisions();
  if (mode == Mode::TRAINING) beginSources();
  options_.mode = mode;
}

void Learner::setPlan(const LearningPlan& plan) {
  LearningParameters parameters = plan.parameters;
  parameters.epsilon = plan.epsilon.at(episode_);
  const std::string problems = parameters.problems();
  if (!problems.empty()) throw InputError(problems);
  mirror_ = mirrorFor(model_, parameters);
  learning_rates_ = LearningRateSchedule(parameters);
  parameters_ = parameters;
  epsilon_ = plan.epsilon;
}

const QTable& Learner::tableOf(AgentId agent) const {
  if (options_.tables == TableUse::SHARED) return *base_;
  const std::uint32_t place = places_.find(agent);
  return place != AgentPlaces::NONE ? *memories_[place].table : *base_;
}

QTable Learner::tableToShare(AgentId agent) {
  nameSource(agent, newSource());
  return tableOf(agent);
}

QTable Learner::tableToSave(AgentId agent) {
  nameSource(agent, tableOf(agent).contentId());
  return tableOf(agent);
}

void Learner::nameSource(AgentId agent, SourceId name) {
  // Without learning, a table has no own visits, or only those of a file, which are identified by its content.
  if (!has_own_sources_) return;
  const std::uint32_t place = places_.find(agent);
  (place == AgentPlaces::NONE ? base_ : memories_[place].table)->nameSource(name);
}

Learner::Taken Learner::give(TablePointer& place, const QTable& table, TakeMethod method) {
  if (method == TakeMethod::REPLACE) {
    const Taken taken = {place->newVisitsOf(table), table.allVisits()};
    place = std::make_shared<QTable>(table);
    return taken;
  }
  auto merged = std::make_shared<QTable>(*place);
  merged->nameSource(newSource());
  const std::uint64_t news = merged->merge(table);
  place = std::move(merged);
  return {news, place->allVisits()};
}

Learner::TakenByAll Learner::takeTable(QTable table, TakeMethod method) {
  checkShape(table);
  beginSources();
  table.beginSource();
  TakenByAll taken;
  const bool own = options_.tables == TableUse::OWN;
  for (std::size_t place = 0; own && place < memories_.size(); ++place) {
    taken.by_agent[places_.agents()[place]] = give(memories_[place].table, table, method);
  }
  taken.newcomers = give(base_, table, method);
  for (Memory& memory : memories_) {
    if (!own || method == TakeMethod::REPLACE) memory.table = base_;  // one copy for all agents
  }
  return taken;
}

Learner::Taken Learner::takeTable(AgentId agent, QTable table, TakeMethod method) {
  if (options_.tables == TableUse::SHARED) return takeTable(std::move(table), method).newcomers;
  checkShape(table);
  beginSources();
  table.beginSource();
  return give(memories_[placeOf(agent)].table, table, method);
}

void Learner::goOnIn(QTable table) {
  checkShape(table);
  base_ = std::make_shared<QTable>(std::move(table));
  for (Memory& memory : memories_) memory.table = base_;
}

void Learner::forgetDecisions() {
  for (Memory& memory : memories_) memory.learner.resetTraces();
}

}  // namespace crowd
