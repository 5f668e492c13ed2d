// Scenario files, pace and status of the crowd controller. Handlers of services access the world through the main loop.

#include <social_crowd/ListScenarios.h>
#include <social_crowd/SetRealTimeFactor.h>

#include <filesystem>
#include <utility>

#include "common/files/files.h"
#include "common/text/numbers.h"
#include "common/text/quotes.h"
#include "ros/controller/crowd_controller.h"
#include "ros/messages/names.h"
#include "scenario/reading/scenario_files.h"
#include "scenario/reading/scenario_reader.h"
#include "scenario/writing/scene_document.h"
#include "simulation/floor_scene.h"

namespace crowd {
namespace {

/// Checks that a scenario file with this content begins with the same scene. In a ghost world, for example, agents may
/// overlap, which no scenario may at its start. @throws InputError with the cause
void requireReadable(const std::string& document, const std::string& file) {
  try {
    parseScenarios(document, file).scene(0, 0);
  } catch (const InputError& error) {
    throw InputError("not saved, as no scenario can begin like this: " + std::string(error.what()));
  }
}

}  // namespace

void CrowdController::loadScenario(const std::string& name, social_crowd::LoadScenario::Response& response) {
  const auto find = [this](const std::string& given, const std::string& folder) {
    return findScenario(given, folder, scenario_folder_);
  };
  const std::string file = data_folder_.resolveToRead(name, find);
  const HiddenQuotes hidden;  // whoever calls may not be allowed to read the file
  // All that may fail or take long is done in this thread; nothing has been replaced yet.
  ScenarioList scenarios = readScenarios(file, stop_);
  const auto seed = loop_.ask<std::uint64_t>([&] { return seed_; });
  scenarios.scene(seed, 0, stop_);
  response.documents = static_cast<std::uint32_t>(scenarios.size());
  loop_.ask<void>([&] {
    {
      const HiddenQuotes hidden_in_loop;
      if (seed_ != seed) scenarios.scene(seed_, 0, stop_);  // the crowd was reset in between
    }
    useScenarios(std::move(scenarios), stemOf(file));
    response.message = "loaded " + file + ": " + place();
    status_.publish();
  });
}

void CrowdController::saveScenario(const social_crowd::SaveScenario::Request& request,
                                   social_crowd::SaveScenario::Response& response) {
  const std::filesystem::path file = data_folder_.resolveToWrite(request.file, request.overwrite != 0);
  std::string left_out;
  const auto scene = loop_.ask<Scene>([&] {
    left_out = leftOutText(episode_->world());
    return sceneOnFloor(*episode_, map_ == nullptr);
  });
  const std::string document = toDocument(scene, file.parent_path().string());
  requireReadable(document, file.string());
  replaceFile(file.string(), document);
  response.message = "saved " + countsText(scene) + left_out + " to " + file.string();
}

void CrowdController::advertiseScenarioServices() {
  files_.serve<social_crowd::LoadScenario>(
      names::LOAD_SCENARIO, [this](const auto& request, auto& response) { loadScenario(request.scenario, response); });
  files_.serve<social_crowd::SaveScenario>(
      names::SAVE_SCENARIO, [this](const auto& request, auto& response) { saveScenario(request, response); });
  files_.serve<social_crowd::ListScenarios>(names::LIST_SCENARIOS, [this](const auto& /*request*/, auto& response) {
    response.folder = scenario_folder_;
    response.names = scenarioNames(scenario_folder_);
    response.data_folder = data_folder_.folder();
    data_folder_.prepare();
    response.message = std::to_string(response.names.size()) + " scenarios in " + response.folder;
  });
  services_.serve<social_crowd::SetRealTimeFactor>(
      names::SET_REAL_TIME_FACTOR, [this](const auto& request, auto& response) {
        loop_.ask<void>([&] {
          use(live_.changed(parameters_, {{"real_time_factor", request.factor}}));
          response.message = "real_time_factor: " + realTimeFactorText(request.factor) + " since " + place();
        });
      });
}

social_crowd::ControllerStatus CrowdController::status() const {
  social_crowd::ControllerStatus status;
  toMessage(episode_->world(), status);
  status.header = broadcaster_.header();
  status.episode = episode_->number();
  status.node = name_;
  status.paused = parameters_.paused ? 1 : 0;
  status.real_time_factor = parameters_.real_time_factor;
  status.scenario = scenario_name_;
  status.seed = seed_;
  status.decisions = decisions_;
  status.missed_answers = answers_.missedCount();
  status.dropped_answers = answers_.droppedCount();
  status.unanswered = answers_.unanswered(episode_->world());
  return status;
}

}  // namespace crowd
