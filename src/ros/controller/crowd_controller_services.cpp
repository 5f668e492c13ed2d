// Services of the crowd controller. Handlers run in service threads and access the world through the main loop.

#include <social_crowd/Reset.h>
#include <social_crowd/Step.h>
#include <std_srvs/SetBool.h>

#include <utility>

#include "ros/controller/crowd_controller.h"
#include "ros/controller/world_services.h"
#include "ros/messages/names.h"

namespace crowd {
namespace {

constexpr std::chrono::milliseconds PAUSE_PATIENCE(500);

}  // namespace

std::string CrowdController::place() const {
  return "episode " + std::to_string(episode_->number()) + ", tick " + std::to_string(episode_->world().tick());
}

std::future<void> CrowdController::pause(bool paused) {
  parameters_.paused = paused;
  status_.publish();
  if (!paused) {
    finishSteps();
    noteRest();
  }
  std::promise<void> rest;
  std::future<void> at_rest = rest.get_future();
  if (paused) {
    waiting_for_rest_.push_back(std::move(rest));
  } else {
    rest.set_value();
  }
  return at_rest;
}

std::future<void> CrowdController::beginSteps(std::uint32_t ticks, std::function<void(bool over)> observe) {
  if (!parameters_.paused) throw InputError("the crowd is walking: call ~pause first");
  if (pending_steps_ != nullptr) throw InputError("another step request is in progress");
  pending_steps_ = std::make_unique<PendingSteps>();
  pending_steps_->left = ticks;
  pending_steps_->observe = std::move(observe);
  return pending_steps_->done.get_future();
}

bool CrowdController::waitFor(const std::future<void>& done, std::chrono::milliseconds timeout) const {
  constexpr std::chrono::milliseconds LOOK(100);
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  while (done.wait_for(std::min(LOOK, timeout)) != std::future_status::ready) {
    if (loop_.isClosed()) throw Error("the node is shutting down");
    if (std::chrono::steady_clock::now() >= deadline) return false;
  }
  return true;
}

void CrowdController::advertiseServices() {
  services_.serve<std_srvs::SetBool>(names::PAUSE, [this](const auto& request, auto& response) {
    const bool paused = request.data != 0;
    // The present tick ends first, unless it waits for a learner.
    const auto at_rest = loop_.ask<std::future<void>>([&] { return pause(paused); });
    const bool rests = waitFor(at_rest, PAUSE_PATIENCE);
    response.message = (!paused ? "walking from "
                        : rests ? "paused at "
                                : "will pause after the present tick, which waits for answers: ") +
                       loop_.ask<std::string>([&] { return place(); });
  });
  services_.serve<social_crowd::Step>(names::STEP, [this](const auto& request, auto& response) {
    if (request.ticks == 0) throw InputError("ticks: expected at least 1, got 0");
    waitFor(loop_.ask<std::future<void>>([&] { return beginSteps(request.ticks); }), std::chrono::hours(24));
    loop_.ask<void>([&] {
      response.episode = episode_->number();
      response.tick = episode_->world().tick();
      response.message = "now at " + place();
    });
  });
  services_.serve<social_crowd::Reset>(names::RESET, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      const std::uint64_t seed = request.keep_seed != 0 ? seed_ : request.seed;
      scenarios_.scene(seed, 0, stop_);  // may throw; nothing has been replaced yet
      Recordings recordings(parameters_, scenario_name_);
      seed_ = seed;
      restart(std::move(recordings));
      response.message = "restarted " + scenario_name_ + ", seed " + std::to_string(seed_) + ": " + place();
    });
  });
  reconfigure_.serve(services_, loop_);
  advertiseScenarioServices();
  advertiseRobotServices();
  visitWorldServices([this](const char* name, auto service) {
    services_.serve<decltype(service)>(name, [this](const auto& request, auto& response) {
      loop_.ask<void>([&] { response.message = serve(*episode_, request, response) + place(); });
    });
  });
}

}  // namespace crowd
