#include "rviz/panel_link.h"

#include <std_msgs/Int32.h>

#include "ros/messages/names.h"
#include "ros/messages/topic_defaults.h"
#include "rviz/panel_calls.h"

namespace crowd {
namespace {}  // namespace

PanelLink::PanelLink(ros::NodeHandle node, const std::string& controller, const std::string& markers)
    : controller_(controller),
      markers_(markers),
      watch_([this](const std::string& service, bool reachable) {
        const std::string name = service.substr(0, service.rfind('/'));
        note([name, reachable](PanelModel& model) { model.noteReachable(name, reachable); });
      }),
      spinner_(1, &queue_) {
  node.setCallbackQueue(&queue_);
  subscribers_ = {
      node.subscribe<social_crowd::ControllerStatus>(names::CONTROLLER_STATUS, LONG_QUEUE,
                                                     [this](const social_crowd::ControllerStatus::ConstPtr& message) {
                                                       note([message,
                                                             now = ros::SteadyTime::now().toSec()](PanelModel& model) {
                                                         if (message->node == model.controller())
                                                           model.take(*message, now);
                                                       });
                                                     }),
      node.subscribe<social_crowd::LearnerStatus>(names::LEARNER_STATUS, LONG_QUEUE,
                                                  [this](const social_crowd::LearnerStatus::ConstPtr& message) {
                                                    note([message](PanelModel& model) { model.take(*message); });
                                                  }),
      node.subscribe<std_msgs::Int32>(
          names::CHOSEN_AGENT, LONG_QUEUE, [this](const std_msgs::Int32::ConstPtr& message) {
            note([agent = message->data](PanelModel& model) { model.takeChosenAgent(agent); });
          })};
  spinner_.start();
}

PanelLink::~PanelLink() {
  for (ros::Subscriber& subscriber : subscribers_) subscriber.shutdown();
  spinner_.stop();
}

void PanelLink::note(Event event) {
  const std::lock_guard<std::mutex> lock(mutex_);
  events_.push_back(std::move(event));
}

void PanelLink::exchange(PanelModel& model) {
  std::vector<Event> events;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    events.swap(events_);
  }
  for (const Event& event : events) event(model);
  std::vector<std::string> services;
  for (const std::string& node : model.watchedNodes()) services.push_back(signOf(node));
  watch_.watch(services);
  for (const PanelRequest& request : model.takeRequests()) {
    ServiceLine& line = lines_[{request.node, request.kind == PanelRequest::Kind::STEP}];
    beginCall(request, line, [this, request](const CallResult& result) {
      note([request, result](PanelModel& model) {
        if (result.scenarios) model.takeScenarios(*result.scenarios, result.data_folder);
        model.noteDone(request, result.success, result.message);
      });
    });
  }
}

std::string PanelLink::signOf(const std::string& node) const {
  const char* const service = node == controller_ ? names::PAUSE
                              : node == markers_  ? names::CHOOSE_AGENT
                                                  : names::SET_MODE;
  return node + "/" + service;
}

}  // namespace crowd
