#include "simulation/evaluation/evaluation.h"

#include <algorithm>
#include <exception>
#include <future>
#include <map>
#include <mutex>
#include <vector>

#include "simulation/evaluation/instance_walk.h"

namespace crowd {
namespace {

/// Distributes instances to threads and delivers their results in order.
class OrderedRun {
 public:
  OrderedRun(std::uint64_t episodes, const EvaluationPlan& plan, const std::function<bool(EvaluatedEpisode&)>& deliver)
      : end_(plan.first + episodes), plan_(plan), deliver_(deliver), handed_out_(plan.first), delivered_(plan.first) {}

  /// Returns the next instance to run in `instance`; false if none is left.
  bool next(std::uint64_t& instance) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (stopped_ || handed_out_ >= end_ || plan_.stop.isMade()) return false;
    instance = handed_out_++;
    return true;
  }

  /// Warns of an episode that is about to be run.
  void begin(const Episode& episode) {
    const std::lock_guard<std::mutex> lock(mutex_);
    plan_.warnOfWays(episode);
  }

  void bring(EvaluatedEpisode walked) {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.emplace(walked.instance, std::move(walked));
    while (!stopped_ && !waiting_.empty() && waiting_.begin()->first == delivered_) {
      stopped_ = true;  // also if deliver_ throws
      stopped_ = !deliver_(waiting_.begin()->second);
      waiting_.erase(waiting_.begin());
      ++delivered_;
    }
  }

  void fail(std::exception_ptr problem) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (problem_ == nullptr) problem_ = std::move(problem);
    stopped_ = true;
  }

  /// Whether all results were delivered and wanted. @throws what fail() was given
  bool isComplete() const {
    if (problem_ != nullptr) std::rethrow_exception(problem_);
    return !stopped_ && delivered_ == end_;
  }

 private:
  std::uint64_t end_;  // number behind the last one
  const EvaluationPlan& plan_;
  const std::function<bool(EvaluatedEpisode&)>& deliver_;
  std::mutex mutex_;
  std::uint64_t handed_out_;
  std::uint64_t delivered_;
  std::map<std::uint64_t, EvaluatedEpisode> waiting_;
  bool stopped_ = false;
  std::exception_ptr problem_;
};

}  // namespace

void EvaluationPlan::warnOfWays(const Episode& episode) const {
  const std::string warning = warn ? episode.result().wayWarning() : "";
  if (!warning.empty()) warn(episode.number(), warning);
}

Learner makeDemoLearner(const TrainedTable& trained, std::uint64_t seed) {
  Learner::Options options;
  options.mode = Mode::DEMO;
  options.seed = seed;
  options.plan.parameters = trained.parameters;
  return {trained.model, options, trained.table};
}

bool evaluate(const TrainedTable& trained, const ScenarioList& scenarios, const EvaluationPlan& plan,
              const std::function<bool(EvaluatedEpisode&)>& deliver) {
  const std::uint64_t episodes = plan.episodes > 0 ? plan.episodes : scenarios.size();
  OrderedRun run(episodes, plan, deliver);
  // If agents keep their heading, each episode depends on the previous one. Threads that are not needed for parallel
  // episodes share the agents within the episodes.
  const std::uint64_t at_a_time = scenarios.keepHeadings() ? 1 : episodes;
  const auto side_by_side = static_cast<unsigned>(std::clamp<std::uint64_t>(at_a_time, 1, std::max(1U, plan.threads)));
  const auto work = [&] {
    try {
      ThreadPool thread_pool(plan.threads / side_by_side);
      Learner learner = makeDemoLearner(trained, plan.seed);
      CrowdDecider decider(learner, thread_pool);
      const auto begin = [&](const Episode& episode) { run.begin(episode); };
      const InstanceWalk walk{plan, learner, thread_pool, decider, begin, {}};
      std::vector<double> headings;  // of the agents at the end of the previous episode
      std::uint64_t instance = 0;
      while (run.next(instance)) {
        Scene scene = scenarios.scene(plan.seed, instance, plan.stop);
        keepHeadings(headings, scene);
        EvaluatedEpisode walked = walk.run(std::move(scene), instance);
        headings = walked.result.headings();
        run.bring(std::move(walked));
      }
    } catch (const Stopped&) {  // the episode is not brought
    } catch (...) {
      run.fail(std::current_exception());
    }
  };
  std::vector<std::future<void>> threads;
  for (unsigned i = 1; i < side_by_side; ++i) threads.push_back(std::async(std::launch::async, work));
  work();
  for (const std::future<void>& thread : threads) thread.wait();
  return run.isComplete();
}

}  // namespace crowd
