#include <chrono>
#include <iostream>

#include "commands.h"
#include "learning/learner.h"
#include "learning/q_table_file.h"
#include "scenario/reading/scenario_reader.h"
#include "simulation/crowd_decider.h"
#include "simulation/episode.h"

namespace crowd::bench {

void walkHeadless(const std::string& scenario, const std::string& q_table, unsigned max_neighbours, unsigned warm_up,
                  unsigned ticks) {
  TrainedTable trained = loadQTable(q_table);
  Learner::Options options;
  options.plan.parameters = trained.parameters;
  Learner learner(trained.model, options, std::move(trained.table));
  Vision vision;  // with the default radius of the controller
  vision.max_neighbours = max_neighbours;
  Episode episode(readScenarios(scenario).scene(1, 0), 0, vision);
  CrowdDecider decider(learner);
  const auto walk = [&](unsigned count) {
    for (unsigned i = 0; i < count; ++i) episode.walk(decider);
  };
  walk(warm_up);
  const auto begin = std::chrono::steady_clock::now();
  walk(ticks);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  std::cout << ticks / seconds.count() << std::endl;
}

}  // namespace crowd::bench
