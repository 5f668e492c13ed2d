// Requests of services, one after the other, each behind a byte that tells which it is; a tick is one of them.

#include <dynamic_reconfigure/Config.h>
#include <social_crowd/SetLearningParameters.h>
#include <social_crowd/SpawnRobot.h>
#include <social_crowd/TakeQTable.h>

#include <functional>
#include <vector>

#include "fuzz/messages.h"
#include "fuzz/small_world.h"
#include "learning/q_table_file.h"
#include "ros/controller/controller_parameters.h"
#include "ros/controller/world_services.h"
#include "ros/learner/learner_settings.h"
#include "ros/node/reconfigure_server.h"
#include "scenario/reading/robot_reader.h"

namespace {

using namespace crowd;

/// What the requests change.
struct Nodes {
  Episode episode{fuzz::smallScene(), 0, {}, ThreadPool::callerOnly(), fuzz::stopAfter(fuzz::PATIENCE)};
  Learner learner = fuzz::makeLearner();
  LearnerSettings settings;
};

using Handler = void (*)(Nodes& nodes, fuzz::MessageStream& stream);

template <typename Service>
void change(Nodes& nodes, fuzz::MessageStream& stream) {
  typename Service::Response response;
  serve(nodes.episode, stream.take<typename Service::Request>(), response);
}

void spawnRobot(Nodes& nodes, fuzz::MessageStream& stream) {
  const auto request = stream.take<social_crowd::SpawnRobot::Request>();
  nodes.episode.edit().addRobot(readRobotStart(request.robot, nodes.episode.scene().goal_tolerance, false));
}

void setLearningParameters(Nodes& nodes, fuzz::MessageStream& stream) {
  const auto request = stream.take<social_crowd::SetLearningParameters::Request>();
  nodes.learner.setPlan(changedPlan(nodes.learner.plan(), request.parameters, "parameters"));
}

void takeQTable(Nodes& nodes, fuzz::MessageStream& stream) {
  const auto request = stream.take<social_crowd::TakeQTable::Request>();
  TrainedTable trained = parseQTable(request.q_table, "table", &nodes.learner.model());
  nodes.learner.tables().take(std::move(trained.table), TAKE_METHODS.parse(request.method));
}

void reconfigure(Nodes& nodes, fuzz::MessageStream& stream) {
  static const LiveParameters<LearnerSettings> live = liveLearnerParameters();
  static const LiveParameters<ControllerParameters> live_controller = liveControllerParameters();
  const LiveChanges changes = changesOf(stream.take<dynamic_reconfigure::Config>());
  live_controller.changed(ControllerParameters(), changes);
  nodes.settings = live.changed(nodes.settings, changes);
  nodes.learner.setPlan(nodes.settings.plan);
}

void walk(Nodes& nodes, fuzz::MessageStream& /*stream*/) { fuzz::walk(nodes.episode); }

std::vector<Handler> allHandlers() {
  std::vector<Handler> handlers = {walk};
  visitWorldServices([&](const char* /*name*/, auto service) { handlers.push_back(change<decltype(service)>); });
  handlers.insert(handlers.end(), {spawnRobot, setLearningParameters, takeQTable, reconfigure});
  return handlers;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed(
      size, 10'000,
      [&] {
        fuzz::MessageStream stream(data, size);
        Nodes nodes;
        static const std::vector<Handler> handlers = allHandlers();
        fuzz::handleAll(handlers, nodes, stream);
        fuzz::walk(nodes.episode);
      },
      fuzz::FLOOR_MEMORY);
}
