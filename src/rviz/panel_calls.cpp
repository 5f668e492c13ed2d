#include "rviz/panel_calls.h"

#include <social_crowd/ChooseAgent.h>
#include <social_crowd/ListScenarios.h>
#include <social_crowd/LoadQTable.h>
#include <social_crowd/LoadScenario.h>
#include <social_crowd/Reset.h>
#include <social_crowd/SaveQTable.h>
#include <social_crowd/SaveScenario.h>
#include <social_crowd/SetLearningParameters.h>
#include <social_crowd/SetMode.h>
#include <social_crowd/SetRealTimeFactor.h>
#include <social_crowd/ShareQTable.h>
#include <social_crowd/Step.h>
#include <std_srvs/SetBool.h>

#include <type_traits>
#include <utility>

#include "common/text/numbers.h"
#include "ros/messages/names.h"

namespace crowd {
namespace {

/// Makes one call of a service.
class Call {
 public:
  Call(const PanelRequest& request, ServiceLine& line, std::function<void(const CallResult&)> report)
      : node_(request.node), line_(line), report_(std::move(report)) {}

  /// @param fill writes the content of the request
  template <typename Service, typename Fill>
  void make(const char* service, const Fill& fill) const {
    using Response = typename Service::Response;
    typename Service::Request content;
    fill(content);
    line_.add<Service>(node_ + "/" + service, content, [report = report_](const Response& response) {
      CallResult result{response.success != 0, response.message};
      if constexpr (std::is_same_v<Response, social_crowd::ListScenarios::Response>) {
        result.scenarios = response.names;
        result.data_folder = response.data_folder;
      }
      report(result);
    });
  }

 private:
  std::string node_;
  ServiceLine& line_;
  std::function<void(const CallResult&)> report_;
};

void callController(const PanelRequest& request, const Call& call) {
  using Kind = PanelRequest::Kind;
  switch (request.kind) {
    case Kind::PAUSE:
      return call.make<std_srvs::SetBool>(names::PAUSE, [&](auto& content) { content.data = request.flag; });
    case Kind::STEP:
      return call.make<social_crowd::Step>(
          names::STEP, [&](auto& content) { content.ticks = static_cast<std::uint32_t>(request.number); });
    case Kind::RESET:
      return call.make<social_crowd::Reset>(names::RESET, [&](auto& content) { content.keep_seed = true; });
    case Kind::SET_SPEED:
      return call.make<social_crowd::SetRealTimeFactor>(names::SET_REAL_TIME_FACTOR,
                                                        [&](auto& content) { content.factor = request.number; });
    case Kind::LOAD_SCENARIO:
      return call.make<social_crowd::LoadScenario>(names::LOAD_SCENARIO,
                                                   [&](auto& content) { content.scenario = request.text; });
    case Kind::SAVE_SCENARIO:
      return call.make<social_crowd::SaveScenario>(names::SAVE_SCENARIO, [&](auto& content) {
        content.file = request.text;
        content.overwrite = request.flag;
      });
    default:
      return call.make<social_crowd::ListScenarios>(names::LIST_SCENARIOS, [](auto& /*content*/) {});
  }
}

void callLearner(const PanelRequest& request, const Call& call) {
  using Kind = PanelRequest::Kind;
  switch (request.kind) {
    case Kind::SET_MODE:
      return call.make<social_crowd::SetMode>(names::SET_MODE, [&](auto& content) { content.mode = request.text; });
    case Kind::SET_PARAMETER:
      return call.make<social_crowd::SetLearningParameters>(names::SET_LEARNING_PARAMETERS, [&](auto& content) {
        content.parameters = "{" + request.text + ": " + toText(request.number) + "}";
      });
    case Kind::SAVE_TABLE:
      return call.make<social_crowd::SaveQTable>(names::SAVE_Q_TABLE, [&](auto& content) {
        content.file = request.text;
        content.agent = static_cast<std::uint32_t>(request.number);
        content.overwrite = request.flag;
      });
    case Kind::LOAD_TABLE:
      return call.make<social_crowd::LoadQTable>(names::LOAD_Q_TABLE,
                                                 [&](auto& content) { content.file = request.text; });
    default:
      return call.make<social_crowd::ShareQTable>(names::SHARE_Q_TABLE, [&](auto& content) {
        content.method = request.text;
        content.from_agent = static_cast<std::uint32_t>(request.number);
      });
  }
}

bool isForLearner(PanelRequest::Kind kind) {
  using Kind = PanelRequest::Kind;
  return kind == Kind::SET_MODE || kind == Kind::SET_PARAMETER || kind == Kind::SAVE_TABLE ||
         kind == Kind::LOAD_TABLE || kind == Kind::SHARE_TABLE;
}

}  // namespace

void beginCall(const PanelRequest& request, ServiceLine& line, std::function<void(const CallResult&)> report) {
  const Call call(request, line, std::move(report));
  if (request.kind == PanelRequest::Kind::CHOOSE_AGENT) {
    return call.make<social_crowd::ChooseAgent>(
        names::CHOOSE_AGENT, [&](auto& content) { content.agent = static_cast<std::int32_t>(request.number); });
  }
  isForLearner(request.kind) ? callLearner(request, call) : callController(request, call);
}

}  // namespace crowd
