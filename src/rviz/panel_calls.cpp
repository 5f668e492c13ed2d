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

  template <typename Service>
  void make(const char* service, const typename Service::Request& content) const {
    using Response = typename Service::Response;
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
    case Kind::PAUSE: {
      std_srvs::SetBool::Request content;
      content.data = request.flag;
      return call.make<std_srvs::SetBool>(names::PAUSE, content);
    }
    case Kind::STEP: {
      social_crowd::Step::Request content;
      content.ticks = static_cast<std::uint32_t>(request.number);
      return call.make<social_crowd::Step>(names::STEP, content);
    }
    case Kind::RESET: {
      social_crowd::Reset::Request content;
      content.keep_seed = true;
      return call.make<social_crowd::Reset>(names::RESET, content);
    }
    case Kind::SET_SPEED: {
      social_crowd::SetRealTimeFactor::Request content;
      content.factor = request.number;
      return call.make<social_crowd::SetRealTimeFactor>(names::SET_REAL_TIME_FACTOR, content);
    }
    case Kind::LOAD_SCENARIO: {
      social_crowd::LoadScenario::Request content;
      content.scenario = request.text;
      return call.make<social_crowd::LoadScenario>(names::LOAD_SCENARIO, content);
    }
    case Kind::SAVE_SCENARIO: {
      social_crowd::SaveScenario::Request content;
      content.file = request.text;
      content.overwrite = request.flag;
      return call.make<social_crowd::SaveScenario>(names::SAVE_SCENARIO, content);
    }
    default:
      return call.make<social_crowd::ListScenarios>(names::LIST_SCENARIOS, {});
  }
}

void callLearner(const PanelRequest& request, const Call& call) {
  using Kind = PanelRequest::Kind;
  switch (request.kind) {
    case Kind::SET_MODE: {
      social_crowd::SetMode::Request content;
      content.mode = request.text;
      return call.make<social_crowd::SetMode>(names::SET_MODE, content);
    }
    case Kind::SET_PARAMETER: {
      social_crowd::SetLearningParameters::Request content;
      content.parameters = "{" + request.text + ": " + toText(request.number) + "}";
      return call.make<social_crowd::SetLearningParameters>(names::SET_LEARNING_PARAMETERS, content);
    }
    case Kind::SAVE_TABLE: {
      social_crowd::SaveQTable::Request content;
      content.file = request.text;
      content.agent = static_cast<std::uint32_t>(request.number);
      content.overwrite = request.flag;
      return call.make<social_crowd::SaveQTable>(names::SAVE_Q_TABLE, content);
    }
    case Kind::LOAD_TABLE: {
      social_crowd::LoadQTable::Request content;
      content.file = request.text;
      return call.make<social_crowd::LoadQTable>(names::LOAD_Q_TABLE, content);
    }
    default: {
      social_crowd::ShareQTable::Request content;
      content.method = request.text;
      content.from_agent = static_cast<std::uint32_t>(request.number);
      return call.make<social_crowd::ShareQTable>(names::SHARE_Q_TABLE, content);
    }
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
    social_crowd::ChooseAgent::Request content;
    content.agent = static_cast<std::int32_t>(request.number);
    return call.make<social_crowd::ChooseAgent>(names::CHOOSE_AGENT, content);
  }
  isForLearner(request.kind) ? callLearner(request, call) : callController(request, call);
}

}  // namespace crowd
