#include "social_crowd/evaluation.h"

#include "common/thread_pool.h"
#include "library/conversions.h"
#include "simulation/evaluation/evaluation.h"
#include "simulation/evaluation/metrics.h"

namespace crowd::library {

Means evaluate(const QTable& table, const Scenario& scenario, const EvaluationOptions& options) {
  EvaluationPlan plan;
  plan.episodes = options.episodes;
  plan.seed = options.seed;
  plan.threads = ThreadPool::countFor(options.threads);
  plan.robot_controller = options.robot_controller;
  Metrics metrics;
  crowd::evaluate(table.trained(), scenario.list(), plan, [&](const EvaluatedEpisode& walked) {
    metrics.add(walked.result);
    return !options.on_episode || options.on_episode(toPublic(walked.result));
  });
  return {metrics.episodes(),      metrics.successPercent(),      metrics.contactPercent(), metrics.collisionPercent(),
          metrics.cleanPercent(),  metrics.pathRatio(),           metrics.timeRatio(),      metrics.turnPerMetre(),
          metrics.maxSpeedRatio(), metrics.blockedMovesPerAgent()};
}

}  // namespace crowd::library
