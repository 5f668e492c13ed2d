#include "ranks/distributed_evaluation.h"

#include <optional>
#include <utility>
#include <vector>

#include "common/files/checksum.h"
#include "scenario/writing/scene_document.h"
#include "simulation/byte_archive.h"
#include "simulation/crowd_decider.h"
#include "simulation/evaluation/instance_walk.h"
#include "simulation/stopwatch.h"

namespace crowd {
namespace {

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

/// What the ranks do together in one evaluation.
class RankEvaluation {
 public:
  RankEvaluation(Communicator& communicator, const TrainedTable& trained, const EvaluationPlan& plan,
                 const RanksObserver& observer)
      : communicator_(communicator),
        records_(plan.record),
        records_states_(plan.states),
        plan_(plan),
        observer_(observer),
        thread_pool_(plan.threads),
        learner_(makeDemoLearner(trained, plan.seed)) {
    if (communicator.rank() == 0) return;
    plan_.record = false;
    plan_.states = false;
    plan_.robot_series = false;
    plan_.robot_log = false;
    plan_.scenes.clear();
    plan_.warn = {};
  }

  /// Whether the floor of a scene is divided among the ranks.
  bool divides(const Scene& scene) const { return !records_states_ && isDivisible(scene); }
  /// Runs an episode. Returns nothing if it was stopped.
  std::optional<EvaluatedEpisode> run(Scene scene, std::uint64_t instance, bool divided) {
    return divided ? walkDivided(std::move(scene), instance) : walkOnFirst(std::move(scene), instance);
  }

 private:
  std::optional<EvaluatedEpisode> walkDivided(Scene scene, std::uint64_t instance);
  std::optional<EvaluatedEpisode> walkOnFirst(Scene scene, std::uint64_t instance);
  void noteTick(std::uint64_t instance, std::uint64_t tick, std::uint64_t max_ticks) const {
    if (observer_.on_tick) observer_.on_tick(instance, tick, max_ticks);
  }
  void report(const RanksReport& report) const {
    if (observer_.on_report) observer_.on_report(report);
  }

  Communicator& communicator_;
  bool records_;         // rank 0 records trajectories
  bool records_states_;  // rank 0 records states
  EvaluationPlan plan_;  // of this rank: only rank 0 records
  const RanksObserver& observer_;
  ThreadPool thread_pool_;
  Learner learner_;
};

std::optional<EvaluatedEpisode> RankEvaluation::walkDivided(Scene scene, std::uint64_t instance) {
  EvaluatedEpisode walked;
  walked.instance = instance;
  if (!plan_.scenes.empty()) walked.scene = toDocument(scene, plan_.scenes);
  DistributedCrowd crowd(scene, instance, learner_, thread_pool_, communicator_);
  scene = Scene();
  do {
    if (records_) crowd.appendTrajectoryRows(walked.ticks.trajectory);
    noteTick(instance, crowd.tick(), crowd.maxTicks());
  } while (crowd.step(plan_.stop.isMade()));
  if (crowd.wasStopped()) return std::nullopt;
  walked.result = crowd.result();
  report(crowd.report());
  return walked;
}

/// Rank 0 walks, the others wait; they return no results.
std::optional<EvaluatedEpisode> RankEvaluation::walkOnFirst(Scene scene, std::uint64_t instance) {
  EvaluatedEpisode walked;
  std::vector<std::uint64_t> stops = {0};
  doOnAllRanks(communicator_, [&] {
    if (communicator_.rank() != 0) return;
    RanksReport measured;
    measured.is_divided = false;
    const std::uint64_t max_ticks = scene.max_ticks;
    CrowdDecider decider(learner_, thread_pool_);
    const InstanceWalk walk{
        plan_,
        learner_,
        thread_pool_,
        decider,
        [&](const Episode& episode) { plan_.warnOfWays(episode); },
        [&](const World& world) {
          measured.ticks += world.tick() > 0 ? 1 : 0;  // with --people-delay, those without robots, too
          noteTick(instance, world.tick(), max_ticks);
        },
    };
    try {
      const Stopwatch whole(CLOCK_MONOTONIC, measured.seconds);
      walked = walk.run(std::move(scene), instance);
    } catch (const Stopped&) {
      stops.front() = 1;
      return;
    }
    measured.ranks = communicator_.size();
    measured.agents = walked.result.agents.size();
    report(measured);
  });
  communicator_.sum(stops);
  if (stops.front() > 0) return std::nullopt;
  return walked;
}

/// What must be the same on all ranks before an episode. @param divided whether the floor is
std::vector<SharedFact> factsOf(const Scene& scene, bool divided) {
  Checksum document;
  if (!divided) document.add(toDocument(scene, "/"));
  return {{"scene of '" + scene.name + "'", checksumOf(scene) + document.text()}};
}

}  // namespace

bool evaluateOnRanks(Communicator& communicator, const TrainedTable& trained, const ScenarioList& scenarios,
                     const EvaluationPlan& plan, const RanksObserver& observer,
                     const std::function<bool(EvaluatedEpisode&)>& deliver) {
  RankEvaluation evaluation(communicator, trained, plan, observer);
  const std::uint64_t episodes = plan.episodes > 0 ? plan.episodes : scenarios.size();
  std::vector<double> headings;
  bool goes_on = true;
  for (std::uint64_t instance = plan.first; instance < plan.first + episodes && goes_on; ++instance) {
    Scene scene;
    std::vector<std::uint64_t> stops = {0};  // ranks
    doOnAllRanks(communicator, [&] {
      try {
        scene = scenarios.scene(plan.seed, instance, plan.stop);
        keepHeadings(headings, scene);
      } catch (const Stopped&) {
        stops.front() = 1;
      }
    });
    communicator.sum(stops);
    if (stops.front() > 0) return false;
    const bool divided = evaluation.divides(scene);
    requireSameOnAllRanks(communicator, factsOf(scene, divided));
    std::optional<EvaluatedEpisode> walked = evaluation.run(std::move(scene), instance, divided);
    if (!walked) return false;
    if (scenarios.keepHeadings()) headings = fromFirstRank(communicator, walked->result.headings());
    std::vector<std::uint64_t> ends = {0};
    doOnAllRanks(communicator, [&] {
      if (communicator.rank() != 0) return;
      ends.front() = deliver(*walked) ? 0 : 1;
    });
    communicator.sum(ends);
    goes_on = ends.front() == 0;
  }
  return goes_on;
}

}  // namespace crowd
