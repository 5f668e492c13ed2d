#include "rviz/panel_link.h"

#include <social_crowd/ControllerStatus.h>
#include <social_crowd/LearnerStatus.h>
#include <std_msgs/Int32.h>

#include "rviz/panel_calls.h"
#include "social_crowd/ros/names.h"

namespace crowd {
namespace {

constexpr std::uint32_t QUEUE = 1000;  // messages; many learners may report at the same time

ControllerInfo toInfo(const social_crowd::ControllerStatus& message) {
  ControllerInfo info;
  info.node = message.node;
  info.episode = message.episode;
  info.tick = message.tick;
  info.time = message.time;
  info.paused = message.paused != 0;
  info.real_time_factor = message.real_time_factor;
  info.scenario = message.scenario;
  info.agents = message.agents;
  info.arrived = message.arrived;
  info.touched = message.touched;
  info.collided = message.collided;
  info.decisions = message.decisions;
  info.missed_answers = message.missed_answers;
  info.unanswered = message.unanswered;
  return info;
}

LearnerInfo toInfo(const social_crowd::LearnerStatus& message) {
  LearnerInfo info;
  info.node = message.node;
  info.mode = message.mode;
  info.has_own_tables = message.tables == "own";
  info.serves_all = message.serves_all != 0;
  info.agents = message.agents;
  info.rows = message.rows;
  info.visited_rows = message.visited_rows;
  info.decisions = message.decisions;
  info.alpha = message.alpha;
  info.gamma = message.gamma;
  info.epsilon = message.epsilon;
  return info;
}

}  // namespace

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
      node.subscribe<social_crowd::ControllerStatus>(names::CONTROLLER_STATUS, QUEUE,
                                                     [this](const social_crowd::ControllerStatus::ConstPtr& message) {
                                                       const double now = ros::SteadyTime::now().toSec();
                                                       note([now, info = toInfo(*message)](PanelModel& model) {
                                                         if (info.node == model.controller()) model.take(info, now);
                                                       });
                                                     }),
      node.subscribe<social_crowd::LearnerStatus>(names::LEARNER_STATUS, QUEUE,
                                                  [this](const social_crowd::LearnerStatus::ConstPtr& message) {
                                                    note([info = toInfo(*message)](PanelModel& model) {
                                                      model.take(info);
                                                    });
                                                  }),
      node.subscribe<std_msgs::Int32>(names::CHOSEN_AGENT, QUEUE, [this](const std_msgs::Int32::ConstPtr& message) {
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
        if (result.scenarios) model.takeScenarios(*result.scenarios);
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
