#include "social_crowd/learning/learner.h"

#include <algorithm>

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
      sight_{model_.state_set->distanceLimits().back(), model_.state_set->maxBodies()},
      stride_(model_.state_set->rowsPerPerception()),
      moves_stride_(model_.state_set->needsMoves() ? blocksOf(model_.action_set->size()) : 0),
      options_(std::move(options)),
      parameters_(options_.plan.parameters),
      step_sizes_(parameters_),
      mirror_(mirrorFor(model_, parameters_)),
      epsilon_(options_.plan.epsilon),
      chance_(options_.seed, KeyedRandom::EXPLORATION, {episode_}),
      base_(std::make_shared<QTable>(std::move(table))) {
  const std::string problems = parameters_.problems();
  if (!problems.empty()) throw InputError(problems);
  checkShape(*base_);
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
  listGuests(perceptions, actions);
  makeRoom(options_.mode == Mode::TRAINING ? guests_.size() : 1, space_);
  // Everybody learns before anybody decides: the decisions of a tick rest on one and the same table.
  if (options_.mode == Mode::TRAINING) learn(perceptions);
  if (!perceptions.last) choose(perceptions, actions);
}

inline void Learner::learnAndChoose(const Perceptions& perceptions, RelativeActions& actions) {
  makeRoom(1, space_);
  const AgentPerception& self = perceptions.agents.front();
  Memory& memory = memories_[placeOf(self.agent)];
  const Choice choice = choiceAt(0, space_);
  const Perception seen = perceptionOf(perceptions, 0, bodiesInSight(perceptions, self));
  if (!self.arrived) findRows(seen, choice);
  learnOne(seen, perceptions, rowsOf(choice), memory);
  actions.agents.clear();
  if (perceptions.last || self.arrived) return;
  const KeyedRandom chance = chance_.with(perceptions.tick);
  const Action action = chooseExploring(chance, perceptions, self, rowsOf(choice), memory);
  answer(seen, choice, action, actions.agents.emplace_back());
}

void Learner::decideGreedily(const Perceptions& perceptions, Space& space, std::vector<AgentAction>& actions) const {
  makeRoom(1, space);
  const Choice choice = choiceAt(0, space);
  for (std::size_t i = 0; i < perceptions.agents.size(); ++i) {
    const AgentPerception& self = perceptions.agents[i];
    if (self.arrived || !serves(self.agent)) continue;
    const Perception seen = perceptionOf(perceptions, i, bodiesInSight(perceptions, self));
    answerGreedily(seen, tableOf(self.agent), choice, actions.emplace_back());
  }
}

inline void Learner::listGuests(const Perceptions& perceptions, RelativeActions& actions) {
  guests_.resize(perceptions.agents.size());
  Guest* guest = guests_.data();
  std::uint32_t answers = 0;
  for (const AgentPerception& self : perceptions.agents) {
    const bool served = serves(self.agent);
    *guest++ = {served ? placeOf(self.agent) : NOBODY, served && !self.arrived ? answers++ : NOBODY,
                bodiesInSight(perceptions, self)};
  }
  actions.agents.resize(perceptions.last ? 0 : answers);
}

template <typename Work>
inline void Learner::forEachGuest(const Perceptions& perceptions, const Work& work) const {
  const std::size_t size = guests_.size();
  if (perceptions.order.size() != size) {
    for (std::size_t index = 0; index < size; ++index) {
      if (guests_[index].answer != NOBODY) work(index);
    }
    return;
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (i + PREFETCH_AHEAD < size) prefetch(perceptions.agents[perceptions.order[i + PREFETCH_AHEAD]]);
    const std::size_t index = perceptions.order[i];
    if (guests_[index].answer != NOBODY) work(index);
  }
}

void Learner::beginEpisode(std::uint64_t episode) {
  began_ = true;
  episode_ = episode;
  chance_ = KeyedRandom(options_.seed, KeyedRandom::EXPLORATION, {episode});
  parameters_.epsilon = epsilon_.at(episode);
  forgetDecisions();
}

inline std::uint32_t Learner::bodiesInSight(const Perceptions& perceptions, const AgentPerception& self) const {
  // Without a limit the state set takes what it looks at from whatever there is.
  if (sight_.max_bodies == 0) return self.body_count;
  std::uint32_t count = std::min(sight_.max_bodies, self.body_count);
  // The nearest comes first.
  while (count > 0 && rimDistance(perceptions.bodies[self.first_body + count - 1]) > sight_.radius) --count;
  return count;
}

inline void Learner::makeRoom(std::size_t choices, Space& space) const {
  if (space.rows.size() >= choices * stride_) return;
  space.rows.resize(choices * stride_);
  space.moves.resize(choices * moves_stride_);
}

inline Learner::Choice Learner::choiceAt(std::size_t place, Space& space) const {
  return {&space.rows[place * stride_], moves_stride_ == 0 ? nullptr : &space.moves[place * moves_stride_]};
}

inline void Learner::findRows(const Perception& seen, const Choice& choice) const {
  if (choice.moves != nullptr) model_.action_set->findMoves(seen, choice.moves);
  model_.state_set->findRows(seen, choice.moves, choice.rows);
}

inline void Learner::learn(const Perceptions& perceptions) {
  // Where there is an order, rows are found from neighbour to neighbour; else when they are needed.
  const bool in_order = !perceptions.order.empty();
  if (in_order) {
    forEachGuest(perceptions,
                 [&](std::size_t index) { findRows(perceptionOf(perceptions, index), choiceAt(index, space_)); });
  }
  const std::size_t size = guests_.size();
  for (std::size_t i = 0; i < size; ++i) {
    const Guest guest = guests_[i];
    if (guest.place == NOBODY) continue;
    const Perception seen = perceptionOf(perceptions, i, guest.bodies);
    const Choice choice = choiceAt(i, space_);
    if (!in_order && guest.answer != NOBODY) findRows(seen, choice);
    learnOne(seen, perceptions, rowsOf(choice), memories_[guest.place]);
  }
}

inline void Learner::learnOne(const Perception& seen, const Perceptions& perceptions, const Rows& rows,
                              Memory& memory) {
  const AgentPerception& now = seen.self;
  if (!memory.learner.hasDecision()) return;
  // What was not carried out, or lies more than a tick back, taught nothing.
  if (!now.acted || memory.episode != perceptions.episode || memory.tick + 1 != perceptions.tick) {
    memory.learner.resetTraces();
    return;
  }
  if (now.arrived) {
    memory.learner.learnTerminal(writable(memory), (*model_.reward)(memory.before, seen, 0), parameters_, step_sizes_,
                                 mirror_);
  } else {
    const double reward = (*model_.reward)(memory.before, seen, rows[0]);
    memory.learner.learn(writable(memory), reward, rows, parameters_, step_sizes_, mirror_);
    if (perceptions.last) memory.learner.resetTraces();
  }
  ++decisions_;
}

inline void Learner::choose(const Perceptions& perceptions, RelativeActions& actions) {
  const bool exploring = options_.mode == Mode::TRAINING;
  const bool shared = options_.tables == TableUse::SHARED;  // then memories need not be looked at
  const KeyedRandom chance = chance_.with(perceptions.tick);
  forEachGuest(perceptions, [&](std::size_t index) {
    const Perception seen = perceptionOf(perceptions, index);
    Memory& memory = memories_[guests_[index].place];
    AgentAction& given = actions.agents[guests_[index].answer];
    if (exploring) {
      const Choice choice = choiceAt(index, space_);
      const Action action = chooseExploring(chance, perceptions, seen.self, rowsOf(choice), memory);
      answer(seen, choice, action, given);
    } else {
      answerGreedily(seen, shared ? *base_ : *memory.table, choiceAt(0, space_), given);
    }
  });
}

inline void Learner::answerGreedily(const Perception& seen, const QTable& table, const Choice& choice,
                                    AgentAction& given) const {
  findRows(seen, choice);
  answer(seen, choice, QLearner::chooseGreedy(table, rowsOf(choice)), given);
}

inline Action Learner::chooseExploring(const KeyedRandom& chance, const Perceptions& perceptions,
                                       const AgentPerception& self, const Rows& rows, Memory& memory) const {
  KeyedRandom random = chance.with(self.agent);
  const double draw = random.uniform();
  const double any = random.uniform();
  const Action action = QLearner::chooseExploring(*memory.table, rows, parameters_.epsilon, draw, any);
  memory.learner.noteDecision(*memory.table, rows, action, parameters_);
  memory.episode = perceptions.episode;
  memory.tick = perceptions.tick;
  memory.before = self;
  return action;
}

inline void Learner::answer(const Perception& seen, const Choice& choice, Action action, AgentAction& given) const {
  given.agent = seen.self.agent;
  // Written to where it stays: a copy of what has just been written would wait until that is in the cache.
  if (choice.moves == nullptr) {
    model_.action_set->findAction(seen, action, given.action);
  } else {
    given.action = toAction(moveAt(choice.moves, action));
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
  options_.mode = mode;
}

void Learner::setParameters(const LearningParameters& parameters) {
  const std::string problems = parameters.problems();
  if (!problems.empty()) throw InputError(problems);
  parameters_ = parameters;
  step_sizes_ = StepSizes(parameters_);
  mirror_ = mirrorFor(model_, parameters_);
  epsilon_ = EpsilonSchedule::constant(parameters.epsilon);
}

const QTable& Learner::tableOf(AgentId agent) const {
  const std::uint32_t place = places_.find(agent);
  return place != AgentPlaces::NONE ? *memories_[place].table : *base_;
}

void Learner::give(TablePointer& place, const QTable& table, TakeMethod method) const {
  auto taken = std::make_shared<QTable>(method == TakeMethod::MERGE ? *place : table);
  if (method == TakeMethod::MERGE) taken->mergeByVisits(table);
  place = std::move(taken);
}

void Learner::takeTable(QTable table, TakeMethod method) {
  checkShape(table);
  const bool merge_each = options_.tables == TableUse::OWN && method == TakeMethod::MERGE;
  give(base_, table, method);
  for (Memory& memory : memories_) {
    if (merge_each) {
      give(memory.table, table, method);
    } else {
      memory.table = base_;
    }
  }
}

void Learner::takeTable(AgentId agent, QTable table, TakeMethod method) {
  if (options_.tables == TableUse::SHARED) return takeTable(std::move(table), method);
  checkShape(table);
  give(memories_[placeOf(agent)].table, table, method);
}

void Learner::forgetDecisions() {
  for (Memory& memory : memories_) memory.learner.resetTraces();
}

}  // namespace crowd
