#include "social_crowd/simulation/training.h"

#include <algorithm>

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

std::vector<EpisodeResult> Training::runNextTurn() {
  if (learners_.size() == 1) return runEpisodes(1);
  QTable table = learner().tableOf(0);
  std::vector<EpisodeResult> results = runEpisodes(config_.training.turn);
  merge(std::move(table));
  return results;
}

std::vector<EpisodeResult> Training::runEpisodes(std::uint64_t each) {
  const std::uint64_t left = config_.training.episodes - episode_;
  std::vector<EpisodeResult> results(std::min(left, each * learners_.size()));
  thread_pool_.run(learners_.size(), [&](unsigned /*worker*/, std::size_t first, std::size_t last) {
    for (std::size_t number = first; number < last; ++number) {
      const std::uint64_t end = std::min<std::uint64_t>((number + 1) * each, results.size());
      for (std::uint64_t i = number * each; i < end; ++i) {
        Scene scene = scenarios_.scene(config_.training.seed, episode_ + i);
        keepHeadings(headings_[number], scene);
        Learner& learner = learners_[number];
        Episode episode(std::move(scene), episode_ + i, learner.model().vision());
        results[i] = runEpisode(episode, learner);
        headings_[number] = results[i].headings();
      }
    }
  });
  episode_ += results.size();
  return results;
}

void Training::merge(QTable table) {
  std::vector<const QTable*> copies;
  for (const Learner& learner : learners_) copies.push_back(&learner.tableOf(0));
  const LearningRateSchedule learning_rates(config_.learning.parameters);
  thread_pool_.run(table.rows(), [&](unsigned /*worker*/, std::size_t begin, std::size_t end) {
    mergeCopies(copies, learning_rates, static_cast<Row>(begin), static_cast<Row>(end), table);
  });
  for (Learner& learner : learners_) learner.restart(table);
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
