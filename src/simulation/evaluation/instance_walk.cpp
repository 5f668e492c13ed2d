#include "simulation/evaluation/instance_walk.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "scenario/writing/scene_document.h"
#include "simulation/evaluation/people_delay.h"
#include "simulation/evaluation/state_record.h"
#include "simulation/evaluation/tick_recorder.h"

namespace crowd {
namespace {

/// Whether people follow a robot, and so have nowhere to go without it.
bool haveFollowers(const Scene& scene) {
  return std::any_of(scene.agents.begin(), scene.agents.end(),
                     [](const AgentStart& agent) { return agent.leader && agent.leader->kind == Leader::Kind::ROBOT; });
}

/// The scene without robots.
Scene withoutRobots(Scene scene) {
  scene.robots.clear();
  return scene;
}

}  // namespace

EvaluatedEpisode InstanceWalk::run(Scene scene, std::uint64_t instance) const {
  scene.robot_metrics = plan.robot_metrics;
  std::optional<Scene> alone;
  if (plan.people_delay && !scene.robots.empty() && !haveFollowers(scene)) {
    scene.ends = Ends::ALL;
    alone = withoutRobots(scene);
  }
  std::string document = plan.scenes.empty() ? "" : toDocument(scene, plan.scenes);
  Episode episode(std::move(scene), instance, learner.model().vision(), thread_pool, plan.stop);
  begin(episode);
  EvaluatedEpisode walked = walk(episode);
  walked.scene = std::move(document);
  if (!alone) return walked;
  Episode same(*std::move(alone), instance, learner.model().vision(), thread_pool, plan.stop);
  EpisodeObserver observer;
  observer.on_tick = on_tick;
  measurePeopleDelay(runEpisode(same, decider, observer), same.scene().tick_duration, walked.result);
  return walked;
}

EvaluatedEpisode InstanceWalk::walk(Episode& episode) const {
  EvaluatedEpisode walked;
  walked.instance = episode.number();
  TickRecorder recorder({plan.record, plan.robot_series, plan.robot_log});
  EpisodeObserver observer;
  observer.on_tick = [&](const World& world) {
    if (on_tick) on_tick(world);
    recorder.record(walked.instance, episode);
  };
  if (plan.states) {
    observer.on_turn = [&](const Perceptions& perceptions) {
      appendStateRows(walked.instance, perceptions, learner, walked.states);
    };
  }
  RobotDrivers robots(plan.robot_controller, episode, learner);
  walked.result = runEpisode(episode, decider, observer, &robots);
  walked.ticks = recorder.take();
  return walked;
}

}  // namespace crowd
