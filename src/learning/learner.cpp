#include "social_crowd/learning/learner.h"

#include <algorithm>

#include "social_crowd/common/random.h"

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
      options_(std::move(options)),
      parameters_(options_.plan.parameters),
      mirror_(mirrorFor(model_, parameters_)),
      epsilon_(options_.plan.epsilon),
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
  actions.agents.clear();
  findRows(perceptions);
  // Everybody learns before anybody decides: the decisions of a tick rest on one and the same table.
  if (options_.mode == Mode::TRAINING) learn(perceptions);
  if (!perceptions.last) choose(perceptions, actions);
}

void Learner::beginEpisode(std::uint64_t episode) {
  began_ = true;
  episode_ = episode;
  parameters_.epsilon = epsilon_.at(episode);
  forgetDecisions();
}

Perception Learner::perceptionOf(const Perceptions& perceptions, std::size_t index) const {
  Perception seen(perceptions, index);
  if (sight_.max_bodies == 0) return seen;  // then the state set takes what it looks at from whatever there is
  std::size_t count = std::min<std::size_t>(sight_.max_bodies, seen.bodies.size());
  const auto rim = [&](std::size_t body) { return seen.bodies[body].position.norm() - seen.bodies[body].radius; };
  while (count > 0 && rim(count - 1) > sight_.radius) --count;  // the nearest comes first
  seen.bodies = {seen.bodies.begin(), count};
  return seen;
}

void Learner::findRows(const Perceptions& perceptions) {
  const std::size_t stride = model_.state_set->rowsPerPerception();
  rows_.resize(perceptions.agents.size() * stride);
  for (std::size_t i = 0; i < perceptions.agents.size(); ++i) {
    const AgentPerception& self = perceptions.agents[i];
    if (serves(self.agent) && !self.arrived)
      model_.state_set->findRows(perceptionOf(perceptions, i), &rows_[i * stride]);
  }
}

Rows Learner::rowsOf(std::size_t index) const {
  const std::size_t stride = model_.state_set->rowsPerPerception();
  return {&rows_[index * stride], stride == 1 ? 0U : 1U};
}

void Learner::learn(const Perceptions& perceptions) {
  for (std::size_t i = 0; i < perceptions.agents.size(); ++i) {
    const AgentPerception& now = perceptions.agents[i];
    if (serves(now.agent)) learnOne(perceptionOf(perceptions, i), perceptions, rowsOf(i));
  }
}

void Learner::learnOne(const Perception& seen, const Perceptions& perceptions, const Rows& rows) {
  const AgentPerception& now = seen.self;
  Memory& memory = memoryOf(now.agent);
  if (!memory.learner.hasDecision()) return;
  // What was not carried out, or lies more than a tick back, taught nothing.
  if (!now.acted || memory.episode != perceptions.episode || memory.tick + 1 != perceptions.tick) {
    memory.learner.resetTraces();
    return;
  }
  if (now.arrived) {
    memory.learner.learnTerminal(writable(memory), (*model_.reward)(memory.before, seen, 0), parameters_, mirror_);
  } else {
    const double reward = (*model_.reward)(memory.before, seen, rows[0]);
    memory.learner.learn(writable(memory), reward, rows, parameters_, mirror_);
    if (perceptions.last) memory.learner.resetTraces();
  }
  ++decisions_;
}

void Learner::choose(const Perceptions& perceptions, RelativeActions& actions) {
  for (std::size_t i = 0; i < perceptions.agents.size(); ++i) {
    const AgentPerception& self = perceptions.agents[i];
    if (!serves(self.agent) || self.arrived) continue;
    Memory& memory = memoryOf(self.agent);
    const Action action = chooseOne(perceptions, rowsOf(i), memory, self.agent);
    memory.episode = perceptions.episode;
    memory.tick = perceptions.tick;
    memory.before = self;
    actions.agents.push_back({self.agent, model_.action_set->relativeAction(perceptionOf(perceptions, i), action)});
  }
}

Action Learner::chooseOne(const Perceptions& perceptions, const Rows& rows, Memory& memory, AgentId agent) const {
  if (options_.mode == Mode::DEMO) return QLearner::chooseGreedy(*memory.table, rows);
  KeyedRandom random(options_.seed, KeyedRandom::EXPLORATION, {perceptions.episode, perceptions.tick, agent});
  const double draw = random.uniform();
  const double any = random.uniform();
  const Action action = QLearner::chooseExploring(*memory.table, rows, parameters_.epsilon, draw, any);
  memory.learner.noteDecision(*memory.table, rows, action, parameters_);
  return action;
}

Learner::Memory& Learner::memoryOf(AgentId agent) {
  Memory& memory = memories_[agent];
  if (memory.table == nullptr) memory.table = base_;
  return memory;
}

QTable& Learner::writable(Memory& memory) {
  const bool read_by_others = options_.tables == TableUse::OWN && memory.table.use_count() > 1;
  if (read_by_others) memory.table = std::make_shared<QTable>(*memory.table);
  return *memory.table;
}

std::vector<AgentId> Learner::servedAgents() const {
  if (!servesAll()) return {options_.agents.begin(), options_.agents.end()};
  std::vector<AgentId> known;
  for (const auto& [agent, memory] : memories_) known.push_back(agent);
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
  mirror_ = mirrorFor(model_, parameters_);
  epsilon_ = EpsilonSchedule::constant(parameters.epsilon);
}

const QTable& Learner::tableOf(AgentId agent) const {
  const auto found = memories_.find(agent);
  return found != memories_.end() ? *found->second.table : *base_;
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
  for (auto& [agent, memory] : memories_) {
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
  give(memoryOf(agent).table, table, method);
}

void Learner::forgetDecisions() {
  for (auto& [agent, memory] : memories_) memory.learner.resetTraces();
}

}  // namespace crowd
