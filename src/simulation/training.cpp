#include "social_crowd/simulation/training.h"

#include <algorithm>
#include <limits>

#include "social_crowd/common/errors.h"
#include "social_crowd/learning/rl/merge_copies.h"
#include "social_crowd/simulation/episode_runner.h"
#include "social_crowd/world/scenario_reader.h"

namespace crowd {
namespace {

Learner::Options trainingOptions(const TrainingConfig& config) {
  Learner::Options options;
  options.mode = Mode::TRAINING;
  options.tables = config.training.tables;
  options.seed = config.training.seed;
  options.plan = config.learning;
  return options;
}

[[noreturn]] void throwEpisodes(const std::string& expected, std::uint64_t got) {
  throw InputError("training.episodes: expected " + expected + ", got " + std::to_string(got));
}

std::vector<Learner> makeLearners(const TrainingConfig& config) {
  const TrainingPlan& plan = config.training;
  if (plan.side_by_side > 1 && config.learning.parameters.lambda > 0.0) {
    throw InputError("training.side_by_side: expected 1 with traces (learning.lambda above 0), got " +
                     std::to_string(plan.side_by_side));
  }
  if (plan.side_by_side > 1 && plan.tables == TableUse::OWN) {
    throw InputError("training.side_by_side: expected 1 with own tables, got " + std::to_string(plan.side_by_side));
  }
  std::vector<Learner> learners;
  for (std::uint32_t i = 0; i < plan.side_by_side; ++i) learners.emplace_back(config.model, trainingOptions(config));
  return learners;
}

}  // namespace

Training::Training(TrainingConfig config, unsigned threads)
    : config_(std::move(config)),
      scenarios_(readScenarios(config_.training.scenarios)),
      learners_(makeLearners(config_)),
      headings_(learners_.size()),
      thread_pool_(std::min(threads, config_.training.side_by_side)) {}

Training::Training(TrainingConfig config, TrainedTable begin, unsigned threads) : Training(std::move(config), threads) {
  requireFit(config_.model, begin.model, "the table to begin with");
  for (Learner& learner : learners_) learner.takeTable(begin.table, TakeMethod::REPLACE);
  learners_.front().setDecisions(begin.decisions);
  decisions_before_ = begin.decisions;
}

std::vector<LearnedEpisode> Training::runNextTurn() {
  if (learners_.size() == 1) return runEpisodes(1);
  QTable table = learner().tableOf(0);
  std::vector<LearnedEpisode> results = runEpisodes(config_.training.turn);
  merge(std::move(table));
  return results;
}

std::vector<LearnedEpisode> Training::runEpisodes(std::uint64_t each) {
  const std::uint64_t left = config_.training.episodes - episode_;
  std::vector<LearnedEpisode> results(std::min(left, each * learners_.size()));
  thread_pool_.run(learners_.size(), [&](unsigned /*worker*/, std::size_t first, std::size_t last) {
    for (std::size_t number = first; number < last; ++number) {
      const std::uint64_t end = std::min<std::uint64_t>((number + 1) * each, results.size());
      for (std::uint64_t i = number * each; i < end; ++i) results[i] = runOne(number, episode_ + i);
    }
  });
  episode_ += results.size();
  return results;
}

LearnedEpisode Training::runOne(std::size_t number, std::uint64_t episode_number) {
  Scene scene = scenarios_.scene(config_.training.seed, episode_number);
  keepHeadings(headings_[number], scene);
  Learner& learner = learners_[number];
  const std::uint64_t decisions = learner.decisions();
  Episode episode(std::move(scene), episode_number, learner.model().vision());
  LearnedEpisode learned{runEpisode(episode, learner)};
  headings_[number] = learned.headings();
  learned.decisions = learner.decisions() - decisions;
  learned.reward = learned.decisions > 0 ? learner.episodeReward() / static_cast<double>(learned.decisions)
                                         : std::numeric_limits<double>::quiet_NaN();
  learned.epsilon = config_.learning.epsilon.at(episode_number);
  if (counts_rows_) learned.visited_rows = visited_rows_ + learner.tableOf(0).newRows();
  return learned;
}

void Training::noteVisitedRows() {
  if (counts_rows_) visited_rows_ = learner().tableOf(0).visitedRows() - learner().tableOf(0).newRows();
}

void Training::countVisitedRows() {
  counts_rows_ = true;
  noteVisitedRows();
}

TrainingState Training::state() const {
  std::vector<std::uint64_t> decisions;
  for (const Learner& learner : learners_) decisions.push_back(learner.decisions());
  std::map<AgentId, QTable> own;
  const QTable& table = learner().baseTable();
  for (const AgentId agent : learner().servedAgents()) {
    if (&learner().tableOf(agent) != &table) own.emplace(agent, learner().tableOf(agent));
  }
  return {episode_, decisions_before_, std::move(decisions), headings_, table, std::move(own)};
}

void Training::restore(TrainingState state) {
  const TrainingPlan& plan = config_.training;
  const std::uint64_t whole_turn = learners_.size() * plan.turn;
  if (state.episode > plan.episodes) {
    throwEpisodes(std::to_string(state.episode) + " episodes or more", plan.episodes);
  }
  if (learners_.size() > 1 && state.episode % whole_turn != 0 && state.episode != plan.episodes) {
    throwEpisodes(std::to_string(state.episode) + " episodes, because the last turn of learners side by side was cut",
                  plan.episodes);
  }
  for (std::size_t i = 0; i < learners_.size(); ++i) {
    learners_[i].restart(state.table);
    learners_[i].setDecisions(state.decisions.at(i));
  }
  for (auto& [agent, table] : state.own) learners_.front().restart(agent, std::move(table));
  headings_ = std::move(state.headings);
  decisions_before_ = state.decisions_before;
  episode_ = state.episode;
  noteVisitedRows();
}

void Training::merge(QTable table) {
  std::vector<const QTable*> copies;
  for (const Learner& learner : learners_) copies.push_back(&learner.tableOf(0));
  const LearningRateSchedule learning_rates(config_.learning.parameters);
  thread_pool_.run(table.rows(), [&](unsigned /*worker*/, std::size_t begin, std::size_t end) {
    mergeCopies(copies, learning_rates, static_cast<Row>(begin), static_cast<Row>(end), table);
  });
  for (Learner& learner : learners_) learner.restart(table);
  noteVisitedRows();
}

std::uint64_t Training::allDecisions() const {
  std::uint64_t sum = 0;
  for (const Learner& learner : learners_) sum += learner.decisions();
  return sum;
}

TrainedTable Training::trained() const {
  LearningParameters parameters = learner().parameters();
  if (episode_ > 0) parameters.epsilon = config_.learning.epsilon.at(episode_ - 1);  // that of the last episode
  return {config_.model, parameters, allDecisions(), config_.training.seed, learner().tableOf(0)};
}

}  // namespace crowd
