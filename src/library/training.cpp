#include "social_crowd/training.h"

#include <utility>

#include "common/files/files.h"
#include "common/thread_pool.h"
#include "library/conversions.h"
#include "training/checkpoint.h"
#include "training/training.h"

namespace crowd::library {
namespace {

crowd::Training makeTraining(const std::string& file, const TrainingOptions& options) {
  TrainingConfig config = readTrainingConfig(file);
  config.training.episodes = options.episodes.value_or(config.training.episodes);
  config.training.seed = options.seed.value_or(config.training.seed);
  const unsigned threads = ThreadPool::countFor(options.threads);
  if (!options.begin) return crowd::Training(std::move(config), threads);
  requireFit(config.model, options.begin->trained().model, file);
  return {std::move(config), options.begin->trained(), threads};
}

}  // namespace

struct Training::State {
  explicit State(const std::string& file, const TrainingOptions& options)
      : training(makeTraining(file, options)), identity(identityOf(training)) {}

  crowd::Training training;
  std::string identity;  // as the files were read
};

Training::Training(const std::string& config, const TrainingOptions& options)
    : state_(std::make_unique<State>(config, options)) {}
Training::Training(Training&&) noexcept = default;
Training& Training::operator=(Training&&) noexcept = default;
Training::~Training() = default;

std::vector<LearnedEpisode> Training::runNextTurn() {
  std::vector<LearnedEpisode> episodes;
  for (const crowd::LearnedEpisode& learned : state_->training.runNextTurn()) {
    episodes.push_back({toPublic(learned), learned.decisions, learned.reward, learned.epsilon});
  }
  return episodes;
}

bool Training::isDone() const { return state_->training.isDone(); }
std::uint64_t Training::episode() const { return state_->training.episode(); }
std::uint64_t Training::episodes() const { return state_->training.config().training.episodes; }
std::uint64_t Training::decisions() const { return state_->training.decisions(); }
QTable Training::table() const { return QTable(std::make_shared<TrainedTable>(state_->training.trained())); }

void Training::saveCheckpoint(const std::string& file) const {
  replaceFile(file, toText(Checkpoint{state_->identity, {}, state_->training.state()}));
}

void Training::resume(const std::string& file) {
  crowd::Training& training = state_->training;
  training.restore(parseCheckpoint(readFile(file), file, state_->identity, training.config().model).state);
}

}  // namespace crowd::library
