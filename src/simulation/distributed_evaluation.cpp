#include "social_crowd/simulation/distributed_evaluation.h"

#include <optional>
#include <vector>

#include "social_crowd/simulation/byte_archive.h"
#include "social_crowd/world/scene_document.h"

namespace crowd {
namespace {

void requireDivisible(const EvaluationPlan& plan, const Scene& scene) {
  const std::string part = plan.states ? "a record of states" : indivisiblePart(scene);
  if (part.empty()) return;
  throw InputError(scene.name + ": on several ranks there is no support for " + part +
                   "; run it without mpirun (docs/mpi.md)");
}

/// Returns rank 0's numbers on all ranks.
std::vector<double> fromFirstRank(Communicator& communicator, const std::vector<double>& numbers) {
  Communicator::Bytes bytes;
  ByteWriter write(bytes);
  for (const double number : numbers) write(number);
  communicator.broadcast(bytes);
  std::vector<double> received;
  ByteReader read(bytes);
  while (!read.isAtEnd()) read(received.emplace_back());
  return received;
}

/// Walks one crowd. Returns nothing if it was stopped.
std::optional<EvaluatedEpisode> walk(DistributedCrowd& crowd, std::uint64_t instance, const EvaluationPlan& plan,
                                     const RanksObserver& observer) {
  EvaluatedEpisode walked;
  walked.instance = instance;
  do {
    if (plan.record) crowd.appendTrajectoryRows(walked.trajectory);
    if (observer.on_tick) observer.on_tick(instance, crowd.tick(), crowd.maxTicks());
  } while (crowd.step(observer.is_stopped && observer.is_stopped()));
  if (crowd.wasStopped()) return std::nullopt;
  walked.result = crowd.result();
  return walked;
}

}  // namespace

bool evaluateOnRanks(Communicator& communicator, const TrainedTable& trained, const ScenarioList& scenarios,
                     const EvaluationPlan& plan, const RanksObserver& observer,
                     const std::function<bool(EvaluatedEpisode&)>& deliver) {
  ThreadPool thread_pool(plan.threads);
  const Learner learner = makeDemoLearner(trained, plan.seed);
  const std::uint64_t episodes = plan.episodes > 0 ? plan.episodes : scenarios.size();
  std::vector<double> headings;
  bool goes_on = true;
  for (std::uint64_t instance = 0; instance < episodes && goes_on; ++instance) {
    Scene scene;
    std::string document;
    doOnAllRanks(communicator, [&] {
      scene = scenarios.scene(plan.seed, instance);
      keepHeadings(headings, scene);
      requireDivisible(plan, scene);
      if (communicator.rank() == 0 && !plan.scenes.empty()) document = toDocument(scene, plan.scenes);
    });
    requireSameOnAllRanks(communicator, {{"scene of '" + scene.name + "'", checksumOf(scene)}});
    DistributedCrowd crowd(scene, instance, learner, thread_pool, communicator);
    scene = Scene();
    std::optional<EvaluatedEpisode> walked = walk(crowd, instance, plan, observer);
    if (!walked) return false;
    const RanksReport report = crowd.report();
    if (observer.on_report) observer.on_report(report);
    if (scenarios.keepHeadings()) headings = fromFirstRank(communicator, walked->result.headings());
    std::vector<std::uint64_t> ends = {0};
    doOnAllRanks(communicator, [&] {
      if (communicator.rank() != 0) return;
      walked->scene = std::move(document);
      ends.front() = deliver(*walked) ? 0 : 1;
    });
    communicator.sum(ends);
    goes_on = ends.front() == 0;
  }
  return goes_on;
}

}  // namespace crowd
