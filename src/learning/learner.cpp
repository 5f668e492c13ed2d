#include "learning/learner.h"

#include <algorithm>

namespace crowd {
namespace {

constexpr std::size_t PART = 128;  // [agents] for which a thread decides at once

Mirror mirrorFor(const Model& model, const LearningParameters& parameters) {
  return parameters.mirrored ? Mirror(*model.state_set, *model.action_set) : Mirror();
}

std::shared_ptr<const ActionSet> actionsOf(const Model& model, Mode mode) {
  const auto while_learning = mode == Mode::TRAINING ? model.action_set->whileLearning() : nullptr;
  return while_learning != nullptr ? while_learning : model.action_set;
}

}  // namespace

Learner::Learner(Model model, Options options)
    : Learner(model, std::move(options), QTable(model.state_set->rowCount(), model.action_set->size())) {}

Learner::Learner(Model model, Options options, QTable table)
    : model_(std::move(model)),
      vision_{model_.state_set->visionRadius(), model_.state_set->maxNeighbours()},
      rows_each_(model_.state_set->rowsPerPerception()),
      blocks_each_(blocksOf(model_.action_set->size())),
      has_constant_moves_(model_.action_set->hasConstantMoves()),
      options_(std::move(options)),
      actions_(actionsOf(model_, options_.mode)),
      parameters_(options_.plan.parameters),
      learning_rates_(parameters_),
      mirror_(mirrorFor(model_, parameters_)),
      epsilon_(options_.plan.epsilon),
      chance_(options_.seed, KeyedRandom::EXPLORATION, {episode_}),
      tables_(std::move(table), options_.tables) {
  const std::string problems = parameters_.problems();
  if (!problems.empty()) throw InputError(problems);
  requireShape(tables_.base(), model_.state_set->rowCount(), model_.action_set->size());
  if (options_.mode == Mode::TRAINING) tables_.beginSources();
}

void Learner::beginEpisode(std::uint64_t episode) {
  began_ = true;
  episode_ = episode;
  chance_ = KeyedRandom(options_.seed, KeyedRandom::EXPLORATION, {episode});
  parameters_.epsilon = epsilon_.at(episode);
  episode_reward_ = 0.0;
  forgetDecisions();
}

std::uint32_t Learner::addAgent(AgentId agent) {
  const std::uint32_t place = tables_.add(agent);
  if (place >= memories_.size()) memories_.resize(place + 1);
  return place;
}

void Learner::forgetDeparted(const Perceptions& perceptions) {
  if (tables_.size() <= most_known_ || tables_.use() == TableUse::OWN) return;
  tables_.forgetIf([&](std::uint32_t place) {
    Memory& memory = memories_[place];
    // In a sequential scenario some agents have not had their turn in this tick yet.
    if (memory.episode == perceptions.episode && memory.tick + 1 >= perceptions.tick) return false;
    memory = Memory();
    return true;
  });
  most_known_ = 2 * tables_.size() + FEW_AGENTS;
}

void Learner::decide(const Perceptions& perceptions, RelativeActions& actions, ThreadPool& thread_pool) {
  if (!began_ || perceptions.episode != episode_) beginEpisode(perceptions.episode);
  actions.episode = perceptions.episode;
  actions.tick = perceptions.tick;
  actions.agents.clear();
  const auto place_of = [this](AgentId agent) { return addAgent(agent); };
  if (options_.mode == Mode::DEMO) {
    for (const AgentPerception& self : perceptions.agents) {
      if (!serves(self.agent)) continue;
      Memory& memory = memories_[addAgent(self.agent)];
      memory.episode = perceptions.episode;
      memory.tick = perceptions.tick;
    }
    forgetDeparted(perceptions);
    return decideInParts(perceptions, actions.agents, thread_pool);
  }
  // All agents learn before any agent decides, so that all decisions of a tick use the same table.
  workspace_.choices.clear();
  perceive(perceptions, 0, perceptions.agents.size(), place_of, workspace_);
  findRows(workspace_);
  learn(perceptions);
  if (perceptions.last) return;
  const KeyedRandom chance = chance_.with(perceptions.tick);
  answer(workspace_, actions.agents, [&](std::size_t k) { return explore(chance, perceptions, k); });
  forgetDeparted(perceptions);
}

void Learner::decideGreedily(const Perceptions& perceptions, DecisionWorkspace& workspace,
                             std::vector<AgentAction>& actions) const {
  workspace.choices.clear();
  if (!perceptions.last) decideSome(perceptions, 0, perceptions.agents.size(), workspace, actions);
}

void Learner::decideInParts(const Perceptions& perceptions, std::vector<AgentAction>& actions,
                            ThreadPool& thread_pool) {
  const std::size_t agents = perceptions.agents.size();
  if (perceptions.last || thread_pool.runsInCaller(agents, ThreadPool::FEW_SHORT_ITEMS))
    return decideGreedily(perceptions, workspace_, actions);
  parts_.resize((agents + PART - 1) / PART);
  workspaces_.resize(thread_pool.count());
  thread_pool.run(parts_.size(), [&](unsigned worker, std::size_t begin, std::size_t end) {
    DecisionWorkspace& workspace = workspaces_[worker];
    for (std::size_t i = begin; i < end; ++i) {
      parts_[i].actions.clear();
      workspace.choices.clear();
      decideSome(perceptions, i * PART, std::min((i + 1) * PART, agents), workspace, parts_[i].actions);
      parts_[i].choices.swap(workspace.choices);
    }
  });
  workspace_.choices.clear();
  for (const Part& part : parts_) {
    actions.insert(actions.end(), part.actions.begin(), part.actions.end());
    workspace_.choices.insert(workspace_.choices.end(), part.choices.begin(), part.choices.end());
  }
}

/// Decides for the agents begin .. end - 1 in demo mode.
void Learner::decideSome(const Perceptions& perceptions, std::size_t begin, std::size_t end,
                         DecisionWorkspace& workspace, std::vector<AgentAction>& actions) const {
  const auto place_of = [this](AgentId agent) { return tables_.placeOf(agent); };
  // One batch after the other, whose data stay in the cache.
  for (std::size_t first = begin; first < end; first += MAX_BATCH) {
    perceive(perceptions, first, std::min(first + MAX_BATCH, end), place_of, workspace);
    findRows(workspace);
    answer(workspace, actions, [&](std::size_t k) {
      const double tie = tieOf(perceptions, workspace.seen[k].self.agent);
      return chooseGreedy(tables_.at(workspace.places[k]), rowsOf(workspace, k), tie);
    });
  }
}

/// Lists the served ones of the agents first .. last - 1.
template <typename PlaceOf>
inline void Learner::perceive(const Perceptions& perceptions, std::size_t first, std::size_t last,
                              const PlaceOf& place_of, DecisionWorkspace& workspace) const {
  workspace.seen.clear();
  workspace.places.clear();
  for (std::size_t index = first; index < last; ++index) {
    const AgentId agent = perceptions.agents[index].agent;
    if (!serves(agent)) continue;
    limit(workspace.seen.emplace_back(perceptions, index));
    workspace.places.push_back(place_of(agent));
  }
}

/// Limits a perception to the model's vision: messages may contain more neighbours.
inline void Learner::limit(Perception& seen) const {
  // Without a limit the state set selects the neighbours itself.
  if (vision_.max_neighbours > 0) seen.neighbours = seen.neighbours.front(vision_.countOf(seen.neighbours));
}

inline void Learner::findRows(DecisionWorkspace& workspace) const {
  const std::size_t agents = workspace.seen.size();
  if (workspace.rows.size() < agents * rows_each_) workspace.rows.resize(agents * rows_each_);
  if (workspace.limits.size() < agents) workspace.limits.resize(agents);
  const bool grows = workspace.moves.size() < agents * blocks_each_;
  if (grows) workspace.moves.resize(agents * blocks_each_);
  // The workspace may have been used by another learner.
  const bool has_moves = has_constant_moves_ && !grows && workspace.moves_of == actions_;
  if (workspace.moves_of != actions_) workspace.moves_of = actions_;
  for (std::size_t first = 0; first < agents; first += MAX_BATCH) {
    const PerceptionBatch batch(&workspace.seen[first], std::min(MAX_BATCH, agents - first));
    MoveBlock* const moves = &workspace.moves[first * blocks_each_];
    if (!has_moves) actions_->findMoves(batch, moves, &workspace.limits[first]);
    model_.state_set->findRows(batch, moves, &workspace.rows[first * rows_each_]);
  }
}

template <typename Choose>
inline void Learner::answer(DecisionWorkspace& workspace, std::vector<AgentAction>& actions,
                            const Choose& choose) const {
  for (std::size_t k = 0; k < workspace.seen.size(); ++k) {
    const AgentPerception& self = workspace.seen[k].self;
    if (self.arrived) continue;
    const Action action = choose(k);
    // Elements are written in place: the loads of a copy would wait for the stores that were just made.
    Choice& choice = workspace.choices.emplace_back();
    choice.row = rowsOf(workspace, k)[action];
    choice.action = action;
    AgentAction& given = actions.emplace_back();
    given.agent = self.agent;
    const MoveBlock* const moves = &workspace.moves[k * blocks_each_];
    given.action = actions_->relativeAction(workspace.seen[k], moves, workspace.limits[k], action);
  }
}

inline void Learner::learn(const Perceptions& perceptions) {
  for (std::size_t k = 0; k < workspace_.seen.size(); ++k) {
    learnOne(workspace_.seen[k], perceptions, rowsOf(workspace_, k), workspace_.places[k]);
  }
}

inline void Learner::learnOne(const Perception& seen, const Perceptions& perceptions, const Rows& rows,
                              std::uint32_t place) {
  const AgentPerception& now = seen.self;
  Memory& memory = memories_[place];
  if (!memory.learner.hasDecision()) return;
  // Nothing is learned from a decision that was not carried out or was made before the previous tick.
  if (!now.acted || memory.episode != perceptions.episode || memory.tick + 1 != perceptions.tick) {
    memory.learner.resetTraces();
    return;
  }
  QTable& table = tables_.writableAt(place);
  const double reward = (*model_.reward)(memory.before, seen, now.arrived ? 0 : rows[0]);
  if (now.arrived) {
    memory.learner.learnTerminal(table, reward, parameters_, learning_rates_, mirror_);
  } else {
    memory.learner.learn(table, reward, rows, parameters_, learning_rates_, mirror_);
    if (perceptions.last) memory.learner.resetTraces();
  }
  episode_reward_ += reward;
  ++decisions_;
}

/// Chooses epsilon-greedily and records the decision.
inline Action Learner::explore(const KeyedRandom& chance, const Perceptions& perceptions, std::size_t k) {
  const AgentPerception& self = workspace_.seen[k].self;
  const QTable& table = tables_.at(workspace_.places[k]);
  const Rows rows = rowsOf(workspace_, k);
  KeyedRandom random = chance.with(self.agent);
  const double draw = random.uniform();
  const double any = random.uniform();
  const Action action =
      chooseEpsilonGreedy(table, rows, parameters_.epsilon, {draw, any, tieOf(perceptions, self.agent)});
  Memory& memory = memories_[workspace_.places[k]];
  memory.learner.recordDecision(table, rows, action, parameters_);
  memory.episode = perceptions.episode;
  memory.tick = perceptions.tick;
  memory.before = self;
  return action;
}

inline double Learner::tieOf(const Perceptions& perceptions, AgentId agent) const {
  if (parameters_.ties == Ties::FIRST) return FIRST_OF_TIES;
  return KeyedRandom(options_.seed, KeyedRandom::TIES, {perceptions.episode, perceptions.tick, agent}).uniform();
}

std::optional<DecisionValues> Learner::valuesOf(const Perceptions& perceptions, const RelativeActions& actions,
                                                AgentId agent) const {
  const auto is_its = [agent](const auto& entry) { return entry.agent == agent; };
  const auto answer = std::find_if(actions.agents.begin(), actions.agents.end(), is_its);
  const auto self = std::find_if(perceptions.agents.begin(), perceptions.agents.end(), is_its);
  if (answer == actions.agents.end() || self == perceptions.agents.end()) return std::nullopt;
  DecisionValues values;
  values.chosen = workspace_.choices[static_cast<std::size_t>(answer - actions.agents.begin())].action;
  DecisionWorkspace workspace;
  const auto index = static_cast<std::size_t>(self - perceptions.agents.begin());
  perceive(
      perceptions, index, index + 1, [this](AgentId id) { return tables_.placeOf(id); }, workspace);
  findRows(workspace);
  const QTable& table = tables_.of(agent);
  const Rows rows = rowsOf(workspace, 0);
  for (Action action = 0; action < table.actions(); ++action) {
    const Row row = rows[action];
    values.moves.push_back(
        {moveAt(workspace.moves.data(), action), row, table.value(row, action), table.visits(row, action)});
  }
  return values;
}

std::vector<AgentId> Learner::servedAgents() const {
  if (!options_.agents.empty()) return {options_.agents.begin(), options_.agents.end()};
  return tables_.agents();
}

void Learner::setMode(Mode mode) {
  if (mode != options_.mode) forgetDecisions();
  if (mode == Mode::TRAINING) tables_.beginSources();
  options_.mode = mode;
  actions_ = actionsOf(model_, mode);
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

void Learner::forgetDecisions() {
  for (Memory& memory : memories_) memory.learner.resetTraces();
}

}  // namespace crowd
