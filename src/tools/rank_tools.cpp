#include "rank_tools.h"

#include <iostream>

#include "command_line.h"
#include "common/files/checksum.h"
#include "common/files/files.h"
#include "training/checkpoint.h"

namespace crowd {

void requireSameRun(Communicator& ranks, const TrainedTable& trained, const std::vector<std::string>& scenario_files,
                    const EvaluationPlan& plan) {
  Checksum table;
  table.add(toText(trained));
  std::string scenarios;
  for (const std::string& file : scenario_files) scenarios += " " + stemOf(file);
  requireSameOnAllRanks(ranks, {{"checksum of the program's library", checksumOfLibrary()},
                                {"checksum of the Q-table", table.text()},
                                {"list of scenarios", scenarios},
                                {"seed", std::to_string(plan.seed)},
                                {"number of episodes", std::to_string(plan.episodes)},
                                {"first episode", std::to_string(plan.first)},
                                {"use of --trajectories", plan.record ? "yes" : "no"},
                                {"use of --states", plan.states ? "yes" : "no"},
                                {"controller of the robots", plan.robot_controller},
                                {"use of --robot-series", plan.robot_series ? "yes" : "no"},
                                {"use of --robot-log", plan.robot_log ? "yes" : "no"},
                                {"use of --people-delay", plan.people_delay ? "yes" : "no"}});
}

void requireSameTraining(Communicator& ranks, const Training& training, const TrainedTable* begin, bool counts_rows) {
  Checksum table;
  if (begin != nullptr) table.add(toText(*begin));
  const TrainingPlan& plan = training.config().training;
  requireSameOnAllRanks(ranks, {{"checksum of the program's library", checksumOfLibrary()},
                                {"training", identityOf(training)},
                                {"number of episodes", std::to_string(plan.episodes)},
                                {"interval of --save-every", std::to_string(plan.save_every)},
                                {"checksum of the Q-table", begin != nullptr ? table.text() : "no table"},
                                {"use of --log or --plot", counts_rows ? "yes" : "no"}});
}

RanksObserver observerOf(const std::string& name, const Communicator& ranks, std::optional<ProgressBar>& bar) {
  RanksObserver observer;
  if (ranks.rank() != 0) return observer;
  observer.on_tick = [&bar, name](std::uint64_t instance, std::uint64_t tick, std::uint64_t max_ticks) {
    if (tick == 0) bar.emplace(name + " " + std::to_string(instance), max_ticks);
    if (tick < max_ticks) bar->show(tick, "ticks");
  };
  observer.on_report = [&bar, name](const RanksReport& report) {
    bar->clear();
    std::cerr << name + ": " + report.text() + "\n";  // one write: mpirun mixes the writes of both streams
  };
  return observer;
}

}  // namespace crowd
