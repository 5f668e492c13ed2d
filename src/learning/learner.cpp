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
  if (options_.mode == Mode::TRAINING) beginSources();
}

void Learner::beginSources() {
  if (has_own_sources_) return;
  base_->beginSource();  // which everybody still uses
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
  listGuests(perceptions, actions);
  if (options_.mode == Mode::TRAINING) {
    // Everybody learns before anybody decides: the decisions of a tick rest on one and the same table.
    learn(perceptions);
    if (!perceptions.last) exploreAll(perceptions, actions);
  } else if (!perceptions.last) {
    chooseGreedily(perceptions, actions);
  }
}

inline void Learner::learnAndChoose(const Perceptions& perceptions, RelativeActions& actions) {
  makeRoom(1, space_);
  const AgentPerception& self = perceptions.agents.front();
  Memory& memory = memories_[placeOf(self.agent)];
  const Chooser chooser = chooserAt(0, perceptionOf(perceptions, 0, bodiesInSight(perceptions, self)), space_);
  if (!self.arrived) findRows(chooser);
  learnOne(chooser.seen, perceptions, rowsOf(chooser), memory);
  actions.agents.clear();
  if (perceptions.last || self.arrived) return;
  const KeyedRandom chance = chance_.with(perceptions.tick);
  const Action action = chooseExploring(chance, perceptions, self, rowsOf(chooser), memory);
  answer(chooser, action, actions.agents.emplace_back());
}

void Learner::decideGreedily(const Perceptions& perceptions, Space& space, std::vector<AgentAction>& actions) const {
  makeRoom(MAX_CHOOSERS, space);
  space.group.clear();
  std::size_t answers = actions.size();
  actions.resize(answers + perceptions.agents.size());
  for (std::size_t i = 0; i < perceptions.agents.size(); ++i) {
    const AgentPerception& self = perceptions.agents[i];
    if (self.arrived || !serves(self.agent)) continue;
    const Perception seen = perceptionOf(perceptions, i, bodiesInSight(perceptions, self));
    joinGreedily(perceptions, seen, answers++, space, actions);
  }
  answerGreedily(perceptions, space, actions);
  actions.resize(answers);
}

Learner::Choice Learner::greedyChoice(const Perceptions& perceptions, std::size_t index, Space& space) const {
  makeRoom(1, space);
  const AgentPerception& self = perceptions.agents[index];
  const Chooser chooser = chooserAt(0, perceptionOf(perceptions, index, bodiesInSight(perceptions, self)), space);
  findRows(chooser);
  const double tie = tieOf(perceptions, self.agent);
  const Action action = QLearner::chooseGreedy(tableOf(self.agent), rowsOf(chooser), tie);
  return {rowsOf(chooser)[action], action};
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

inline Chooser Learner::chooserAt(std::size_t place, const Perception& seen, Space& space) const {
  return {seen, moves_stride_ == 0 ? nullptr : &space.moves[place * moves_stride_], &space.rows[place * stride_]};
}

inline void Learner::findRows(const Chooser& chooser) const {
  if (chooser.moves != nullptr) model_.action_set->findMoves(chooser);
  model_.state_set->findRows(chooser);
}

inline void Learner::findRowsOfGroup(const Space& space) const {
  const Choosers group(space.group.data(), space.group.size());
  if (moves_stride_ > 0) model_.action_set->findMovesOfAll(group);
  model_.state_set->findRowsOfAll(group);
}

inline void Learner::learn(const Perceptions& perceptions) {
  findAllRows(perceptions);
  const std::size_t size = guests_.size();
  for (std::size_t i = 0; i < size; ++i) {
    const Guest guest = guests_[i];
    if (guest.place == NOBODY) continue;
    const Chooser chooser = chooserAt(i, perceptionOf(perceptions, i), space_);
    learnOne(chooser.seen, perceptions, rowsOf(chooser), memories_[guest.place]);
  }
}

/// Of all guests that are to answer: nothing of what is learned changes their rows.
inline void Learner::findAllRows(const Perceptions& perceptions) {
  makeRoom(guests_.size(), space_);
  space_.group.clear();
  const auto find = [&] {
    findRowsOfGroup(space_);
    space_.group.clear();
  };
  forEachGuest(perceptions, [&](std::size_t index) {
    space_.group.add(chooserAt(index, perceptionOf(perceptions, index), space_));
    if (space_.group.isFull()) find();
  });
  find();
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

inline void Learner::exploreAll(const Perceptions& perceptions, RelativeActions& actions) {
  const KeyedRandom chance = chance_.with(perceptions.tick);
  forEachGuest(perceptions, [&](std::size_t index) {
    const Guest guest = guests_[index];
    const Chooser chooser = chooserAt(index, perceptionOf(perceptions, index), space_);
    const Action action =
        chooseExploring(chance, perceptions, chooser.seen.self, rowsOf(chooser), memories_[guest.place]);
    answer(chooser, action, actions.agents[guest.answer]);
  });
}

inline void Learner::chooseGreedily(const Perceptions& perceptions, RelativeActions& actions) {
  makeRoom(MAX_CHOOSERS, space_);
  space_.group.clear();
  forEachGuest(perceptions, [&](std::size_t index) {
    joinGreedily(perceptions, perceptionOf(perceptions, index), guests_[index].answer, space_, actions.agents);
  });
  answerGreedily(perceptions, space_, actions.agents);
}

inline double Learner::tieOf(const Perceptions& perceptions, AgentId agent) const {
  if (parameters_.ties == Ties::FIRST) return QLearner::FIRST_OF_TIES;
  return KeyedRandom(options_.seed, KeyedRandom::TIES, {perceptions.episode, perceptions.tick, agent}).uniform();
}

inline void Learner::joinGreedily(const Perceptions& perceptions, const Perception& seen, std::size_t answer,
                                  Space& space, std::vector<AgentAction>& actions) const {
  const std::size_t place = space.group.size();
  space.group.add(chooserAt(place, seen, space));
  space.answers[place] = answer;
  if (space.group.isFull()) answerGreedily(perceptions, space, actions);
}

inline void Learner::answerGreedily(const Perceptions& perceptions, Space& space,
                                    std::vector<AgentAction>& actions) const {
  findRowsOfGroup(space);
  const auto& group = space.group;
  std::array<Action, MAX_CHOOSERS> chosen;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  for (std::size_t k = 0; k < group.size(); ++k) {
    const AgentId agent = group[k].seen.self.agent;
    chosen[k] = QLearner::chooseGreedy(tableOf(agent), rowsOf(group[k]), tieOf(perceptions, agent));
  }
  for (std::size_t k = 0; k < group.size(); ++k) answer(group[k], chosen[k], actions[space.answers[k]]);
  space.group.clear();
}

inline Action Learner::chooseExploring(const KeyedRandom& chance, const Perceptions& perceptions,
                                       const AgentPerception& self, const Rows& rows, Memory& memory) const {
  KeyedRandom random = chance.with(self.agent);
  const double draw = random.uniform();
  const double any = random.uniform();
  const double tie = tieOf(perceptions, self.agent);
  const Action action = QLearner::chooseExploring(*memory.table, rows, parameters_.epsilon, draw, any, tie);
  memory.learner.noteDecision(*memory.table, rows, action, parameters_);
  memory.episode = perceptions.episode;
  memory.tick = perceptions.tick;
  memory.before = self;
  return action;
}

inline void Learner::answer(const Chooser& chooser, Action action, AgentAction& given) const {
  given.agent = chooser.seen.self.agent;
  // Written to where it stays: a copy of what has just been written would wait until that is in the cache.
  if (chooser.moves == nullptr) {
    model_.action_set->findAction(chooser.seen, action, given.action);
  } else {
    given.action = toAction(moveAt(chooser.moves, action));
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
  step_sizes_ = StepSizes(parameters);
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
  // What nobody has learned in has no visits of its own, or those of a file, which are named by its content.
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
    if (!own || method == TakeMethod::REPLACE) memory.table = base_;  // one copy does for all
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
