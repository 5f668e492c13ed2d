#include "training/training.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "learning/rl/merge_copies.h"
#include "scenario/reading/scenario_reader.h"
#include "simulation/byte_archive.h"
#include "simulation/episode_runner.h"
#include "simulation/stopwatch.h"
#include "social_crowd/errors.h"
#include "training/learned_episode_transfer.h"
#include "training/table_exchange.h"

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

void requireLearnersSideBySide(const TrainingConfig& config, int ranks) {
  const TrainingPlan& plan = config.training;
  if (plan.side_by_side > 1 && config.learning.parameters.lambda > 0.0) {
    throw InputError("training.side_by_side: expected 1 with traces (learning.lambda above 0), got " +
                     std::to_string(plan.side_by_side));
  }
  if (plan.side_by_side > 1 && plan.tables == TableUse::OWN) {
    throw InputError("training.side_by_side: expected 1 with own tables, got " + std::to_string(plan.side_by_side));
  }
  if (plan.side_by_side < static_cast<std::uint32_t>(ranks)) {
    throw InputError("training.side_by_side: expected " + std::to_string(ranks) +
                     " or more learners side by side for " + std::to_string(ranks) + " ranks, got " +
                     std::to_string(plan.side_by_side) + ": set it, or start fewer ranks");
  }
}

/// Returns the first learner of a rank. The learners are divided into blocks whose sizes differ by at most one.
std::size_t firstLearner(const TrainingConfig& config, const Communicator& communicator, int rank) {
  return std::size_t{config.training.side_by_side} * static_cast<std::size_t>(rank) /
         static_cast<std::size_t>(communicator.size());
}

std::vector<Learner> makeLearners(const TrainingConfig& config, const Communicator& communicator) {
  requireLearnersSideBySide(config, communicator.size());
  const std::size_t end = firstLearner(config, communicator, communicator.rank() + 1);
  std::vector<Learner> learners;
  for (std::size_t i = firstLearner(config, communicator, communicator.rank()); i < end; ++i) {
    learners.emplace_back(config.model, trainingOptions(config));
  }
  return learners;
}

}  // namespace

Training::Training(TrainingConfig config, unsigned threads, Communicator& communicator)
    : config_(std::move(config)),
      communicator_(communicator),
      scenarios_(readScenarios(config_.training.scenarios)),
      first_(firstLearner(config_, communicator, communicator.rank())),
      learners_(makeLearners(config_, communicator)),
      decisions_(config_.training.side_by_side),
      headings_(config_.training.side_by_side),
      thread_pool_(std::min<unsigned>(threads, static_cast<unsigned>(learners_.size()))) {}

Training::Training(TrainingConfig config, TrainedTable begin, unsigned threads, Communicator& communicator)
    : Training(std::move(config), threads, communicator) {
  requireFit(config_.model, begin.model, "the table to begin with");
  for (Learner& learner : learners_) learner.tables().take(begin.table, TakeMethod::REPLACE);
  decisions_.front() = begin.decisions;
  decisions_before_ = begin.decisions;
}

std::vector<LearnedEpisode> Training::runNextTurn() {
  const Stopwatch whole(CLOCK_MONOTONIC, times_.seconds);
  const std::uint64_t sent = communicator_.sentBytes();
  const std::uint64_t each = learners() == 1 ? 1 : config_.training.turn;
  const Turn turn{each, std::min(config_.training.episodes - episode_, each * learners())};
  std::optional<QTable> table;  // before the turn
  if (learners() > 1) table = learner().tables().of(0);
  std::vector<LearnedEpisode> episodes = runEpisodes(turn);
  const Stopwatch exchange(CLOCK_MONOTONIC, times_.exchange_seconds);
  if (communicator_.size() > 1) collect(episodes);
  note(turn, communicator_.rank() == 0 ? 0 : first_, episodes);
  episode_ += turn.episodes;
  if (table) merge(std::move(*table));
  ++times_.turns;
  times_.bytes += communicator_.sentBytes() - sent;
  if (communicator_.rank() != 0) episodes.clear();
  return episodes;
}

std::vector<LearnedEpisode> Training::runEpisodes(const Turn& turn) {
  const std::uint64_t first = turn.begin(first_);
  std::vector<LearnedEpisode> results(turn.begin(first_ + learners_.size()) - first);
  const auto run = [&] {
    const Stopwatch busy(CLOCK_MONOTONIC, times_.episode_seconds);
    thread_pool_.run(learners_.size(), [&](unsigned /*worker*/, std::size_t begin, std::size_t end) {
      for (std::size_t own = begin; own < end; ++own) {
        for (std::uint64_t i = turn.begin(first_ + own); i < turn.end(first_ + own); ++i) {
          results[i - first] = runOne(own, episode_ + i);
        }
      }
    });
  };
  if (communicator_.size() == 1) {
    run();
  } else {
    doOnAllRanks(communicator_, run);
  }
  return results;
}

void Training::collect(std::vector<LearnedEpisode>& episodes) {
  std::vector<Communicator::Bytes> out(static_cast<std::size_t>(communicator_.size()));
  if (communicator_.rank() != 0) {
    ByteWriter write(out.front());
    for (const LearnedEpisode& episode : episodes) transferEpisode(write, episode);
  }
  std::vector<Communicator::Bytes> in;
  communicator_.exchangeAnySize(out, in);
  for (const Communicator::Bytes& bytes : in) {
    ByteReader read(bytes);
    while (!read.isAtEnd()) transferEpisode(read, episodes.emplace_back());
  }
}

void Training::note(const Turn& turn, std::size_t first, const std::vector<LearnedEpisode>& episodes) {
  std::size_t learner = first;
  std::uint64_t number = turn.begin(first);
  for (const LearnedEpisode& episode : episodes) {
    while (number >= turn.end(learner)) ++learner;
    decisions_[learner] += episode.decisions;
    const bool is_own = learner >= first_ && learner < first_ + learners_.size();
    if (!is_own) headings_[learner] = episode.headings();
    ++number;
  }
}

LearnedEpisode Training::runOne(std::size_t own, std::uint64_t episode_number) {
  Scene scene = scenarios_.scene(config_.training.seed, episode_number);
  std::vector<double>& headings = headings_[first_ + own];
  keepHeadings(headings, scene);
  Learner& learner = learners_[own];
  const std::uint64_t decisions = learner.decisions();
  Episode episode(std::move(scene), episode_number, learner.model().vision());
  CrowdDecider decider(learner);
  LearnedEpisode learned{runEpisode(episode, decider)};
  headings = learned.headings();
  learned.decisions = learner.decisions() - decisions;
  learned.reward = learned.decisions > 0 ? learner.episodeReward() / static_cast<double>(learned.decisions)
                                         : std::numeric_limits<double>::quiet_NaN();
  learned.epsilon = config_.learning.epsilon.at(episode_number);
  if (counts_rows_) learned.visited_rows = visited_rows_ + learner.tables().of(0).newRows();
  return learned;
}

void Training::noteVisitedRows() {
  if (counts_rows_) visited_rows_ = learner().tables().of(0).visitedRows() - learner().tables().of(0).newRows();
}

void Training::countVisitedRows() {
  counts_rows_ = true;
  noteVisitedRows();
}

TrainingState Training::state() const {
  std::map<AgentId, QTable> own;
  const QTable& table = learner().tables().base();
  for (const AgentId agent : learner().servedAgents()) {
    if (&learner().tables().of(agent) != &table) own.emplace(agent, learner().tables().of(agent));
  }
  return {episode_, decisions_before_, decisions_, headings_, table, std::move(own)};
}

void Training::restore(TrainingState state) {
  const TrainingPlan& plan = config_.training;
  const std::uint64_t whole_turn = learners() * plan.turn;
  if (state.decisions.size() != learners() || state.headings.size() != learners()) {
    throw InputError("training.side_by_side: expected " + std::to_string(state.decisions.size()) + ", got " +
                     std::to_string(learners()));
  }
  if (state.episode > plan.episodes) {
    throwEpisodes(std::to_string(state.episode) + " episodes or more", plan.episodes);
  }
  if (learners() > 1 && state.episode % whole_turn != 0 && state.episode != plan.episodes) {
    throwEpisodes(std::to_string(state.episode) + " episodes, because the last turn of learners side by side was cut",
                  plan.episodes);
  }
  for (Learner& learner : learners_) learner.tables().restart(state.table);
  for (auto& [agent, table] : state.own) learners_.front().tables().restart(agent, std::move(table));
  headings_ = std::move(state.headings);
  decisions_ = std::move(state.decisions);
  decisions_before_ = state.decisions_before;
  episode_ = state.episode;
  noteVisitedRows();
}

void Training::merge(QTable table) {
  std::vector<const QTable*> copies;
  for (const Learner& learner : learners_) copies.push_back(&learner.tables().of(0));
  const LearningRateSchedule learning_rates(config_.learning.parameters);
  if (communicator_.size() == 1) {
    thread_pool_.run(table.rows(), [&](unsigned /*worker*/, std::size_t begin, std::size_t end) {
      mergeCopies(copies, learning_rates, static_cast<Row>(begin), static_cast<Row>(end), table);
    });
  } else {
    mergeOnRanks(communicator_, copies, learning_rates, thread_pool_, table);
  }
  for (Learner& learner : learners_) learner.tables().restart(table);
  noteVisitedRows();
}

std::uint64_t Training::allDecisions() const {
  return std::accumulate(decisions_.begin(), decisions_.end(), std::uint64_t{0});
}

TurnsReport Training::report() const { return reportOf(communicator_, times_, learners()); }

TrainedTable Training::trained() const {
  LearningParameters parameters = learner().parameters();
  if (episode_ > 0) parameters.epsilon = config_.learning.epsilon.at(episode_ - 1);  // that of the last episode
  return {config_.model, parameters, allDecisions(), config_.training.seed, learner().tables().of(0)};
}

}  // namespace crowd
