#include "social_crowd/simulation/training.h"

#include "social_crowd/simulation/episode.h"
#include "social_crowd/world/scenario_reader.h"

namespace crowd {
namespace {

ScenarioList readAll(const std::vector<std::string>& files) {
  std::vector<Scenario> all;
  for (const std::string& file : files) {
    const ScenarioList scenarios = readScenarios(file);
    for (std::size_t i = 0; i < scenarios.size(); ++i) all.push_back(scenarios[i]);
  }
  return ScenarioList(std::move(all));
}

Learner::Options trainingOptions(const Recipe& recipe) {
  Learner::Options options;
  options.mode = Mode::TRAINING;
  options.tables = recipe.training.tables;
  options.seed = recipe.training.seed;
  options.plan = recipe.learning;
  return options;
}

}  // namespace

EpisodeResult runEpisode(const Scene& scene, std::uint64_t number, Learner& learner) {
  Episode episode(scene, number, learner.model().vision());
  RelativeActions actions;
  learner.decide(episode.perceptions(), actions);
  while (!episode.isOver()) {
    episode.step(actions.agents);
    learner.decide(episode.perceptions(), actions);
  }
  return episode.result();
}

Training::Training(Recipe recipe)
    : recipe_(std::move(recipe)),
      scenarios_(readAll(recipe_.training.scenarios)),
      learner_(recipe_.model, trainingOptions(recipe_)) {}

Training::Training(Recipe recipe, TrainedTable begin) : Training(std::move(recipe)) {
  requireFit(recipe_.model, begin.model, "the table to begin with");
  learner_.takeTable(std::move(begin.table), TakeMethod::REPLACE);
  learner_.setDecisions(begin.decisions);
  decisions_before_ = begin.decisions;
}

EpisodeResult Training::runNextEpisode() {
  EpisodeResult result = runEpisode(scenarios_.scene(recipe_.training.seed, episode_), episode_, learner_);
  ++episode_;
  return result;
}

TrainedTable Training::trained() const {
  return {recipe_.model, learner_.parameters(), learner_.decisions(), recipe_.training.seed, learner_.tableOf(0)};
}

}  // namespace crowd
