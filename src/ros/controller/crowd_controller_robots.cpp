// Services of the crowd controller for robots.

#include <social_crowd/RemoveRobot.h>
#include <social_crowd/SpawnRobot.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "ros/controller/crowd_controller.h"
#include "ros/messages/names.h"
#include "scenario/reading/robot_reader.h"

namespace crowd {
namespace {

std::string newRobotName(const Robots& robots) {
  for (std::size_t i = 0;; ++i) {
    std::string name = "robot_" + std::to_string(i);
    const auto has_it = [&](const Robot& robot) { return robot.start.name == name || robot.start.name_space == name; };
    if (std::none_of(robots.begin(), robots.end(), has_it)) return name;
  }
}

}  // namespace

std::future<void> CrowdController::beginRobotSteps(
    const social_crowd::StepRobots::Request& request,
    const std::shared_ptr<social_crowd::StepRobots::Response>& response) {
  if (!parameters_.paused || !episode_->beginsTick()) throw InputError("the crowd is walking: call ~pause first");
  if (pending_steps_ != nullptr) throw InputError("another step request is in progress");
  const auto observe = [this, response, request](bool over) {
    response->episode = episode_->number();
    response->tick = episode_->world().tick();
    response->done = over ? 1 : 0;
    response->observations = robots_.observations(broadcaster_.header().stamp, request);
    response->message = "now at " + place();
  };
  const CommandCollector::Commands commands = robots_.commands().commandsOf(request.robots, request.commands);
  if (request.ticks > 0) {
    robots_.beginSteps(commands);
    return beginSteps(request.ticks, observe);
  }
  observe(false);
  std::promise<void> done;
  done.set_value();
  return done.get_future();
}

void CrowdController::advertiseRobotServices() {
  services_.serve<social_crowd::SpawnRobot>(names::SPAWN_ROBOT, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      const Robots& robots = episode_->world().robots();
      const RobotStart start =
          readRobotStart(request.robot, episode_->scene().goal_tolerance, robots.empty(), newRobotName(robots));
      robots_.add(start);
      response.message = "robot " + start.name + " added at " + place();
    });
  });
  services_.serve<social_crowd::RemoveRobot>(names::REMOVE_ROBOT, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      robots_.remove(request.robot);
      response.message = "robot " + request.robot + " removed at " + place();
    });
  });
  services_.serve<social_crowd::StepRobots>("step_robots", [this](const auto& request, auto& response) {
    // Shared with the main loop, which may still write it when this call has ended because the node shuts down.
    const auto result = std::make_shared<social_crowd::StepRobots::Response>(response);
    waitFor(loop_.ask<std::future<void>>([&] { return beginRobotSteps(request, result); }), std::chrono::hours(24));
    loop_.ask<void>([&] {
      if (result->observations.empty()) throw Error("another call of a service ended the steps");
      response = *result;
    });
  });
}

}  // namespace crowd
