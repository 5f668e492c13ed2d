#include "rviz/panel_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "rviz/panel_texts.h"

namespace crowd {
namespace {

using social_crowd::ControllerStatus;
using social_crowd::LearnerStatus;
using Kind = PanelRequest::Kind;

constexpr double RATE_PERIOD = 2.0;      // [s], over which decisions are counted
constexpr std::size_t MOST_WATCHED = 8;  // learners; each is called once per second

/// Requests of the same line are made one after the other.
bool areOfOneLine(const PanelRequest& a, const PanelRequest& b) {
  return a.node == b.node && (a.kind == Kind::STEP) == (b.kind == Kind::STEP);
}

bool isSave(const PanelRequest& request) {
  return request.kind == Kind::SAVE_SCENARIO || request.kind == Kind::SAVE_TABLE;
}

/// Requests of which the last one counts; others are all made, such as those to save different files.
bool isReplacedBy(const PanelRequest& old, const PanelRequest& request) {
  const bool has_name = old.kind == Kind::SET_PARAMETER || isSave(old);
  return old.kind == request.kind && old.node == request.node && (!has_name || old.text == request.text);
}

bool hasOwnTables(const LearnerStatus& learner) { return learner.tables == "own"; }

bool serves(const LearnerStatus& learner, std::int64_t agent) {
  return learner.serves_all != 0 || std::any_of(learner.agents.begin(), learner.agents.end(),
                                                [&](std::uint32_t served) { return served == agent; });
}

std::string timeText(double seconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f s", seconds);
  return text.data();
}

}  // namespace

PanelModel::PanelModel(std::string controller, std::string markers)
    : controller_(std::move(controller)), markers_(std::move(markers)) {}

void PanelModel::take(const ControllerStatus& status, double now) {
  const bool restarted = status.decisions < status_.decisions || status.episode < status_.episode;
  if (restarted || !has_status_) decisions_.clear();
  if (restarted && has_status_) ask({Kind::LIST_SCENARIOS, controller_});  // its folder may be another one
  decisions_.emplace_back(now, status.decisions);
  while (now - decisions_.front().first > RATE_PERIOD) decisions_.pop_front();
  status_ = status;
  has_status_ = true;
}

void PanelModel::take(const LearnerStatus& learner) {
  learners_[learner.node] = learner;
  reachable_.insert(learner.node);  // its status has just come; not all of many learners are watched
}

void PanelModel::noteReachable(const std::string& node, bool reachable) {
  if (reachable == isReachable(node)) return;
  if (!reachable) {
    reachable_.erase(node);
    dropRequests(node);
    return;
  }
  reachable_.insert(node);
  if (node == controller_) ask({Kind::LIST_SCENARIOS, controller_});
}

void PanelModel::dropRequests(const std::string& node) {
  const auto is_for = [&](const PanelRequest& request) { return request.node == node; };
  for (const PanelRequest& request : waiting_) {
    if (!is_for(request) || !isSave(request)) continue;
    message_ = request.text + " is not saved: " + node + " is away";
    is_error_ = true;
  }
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_for), waiting_.end());
}

void PanelModel::noteDone(const PanelRequest& request, bool success, const std::string& message) {
  const auto is_it = [&](const PanelRequest& one) {
    return one.kind == request.kind && one.node == request.node && one.text == request.text;
  };
  const auto found = std::find_if(running_.begin(), running_.end(), is_it);
  if (found != running_.end()) running_.erase(found);
  if (request.kind == Kind::LIST_SCENARIOS && success) return;
  message_ = message;
  is_error_ = !success;
  if (request.kind == Kind::SAVE_SCENARIO && success) ask({Kind::LIST_SCENARIOS, controller_});  // it may be in there
}

std::vector<std::string> PanelModel::watchedNodes() const {
  std::vector<std::string> nodes{controller_, markers_};
  const auto watch = [&](const std::string& node) {
    if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) nodes.push_back(node);
  };
  if (learners_.count(learner_) > 0) watch(learner_);
  if (const LearnerStatus* const learner = tableLearner()) watch(learner->node);
  for (auto learner = learners_.begin(); learner != learners_.end() && nodes.size() < MOST_WATCHED; ++learner) {
    watch(learner->first);
  }
  return nodes;
}

void PanelModel::ask(PanelRequest request) {
  if (!isReachable(request.node)) return;
  const auto same =
      std::find_if(waiting_.begin(), waiting_.end(), [&](const auto& old) { return isReplacedBy(old, request); });
  if (same != waiting_.end()) waiting_.erase(same);
  waiting_.push_back(std::move(request));
}

void PanelModel::askLearners(const PanelRequest& request) {
  for (const LearnerStatus* const learner : learners()) {
    PanelRequest one = request;
    one.node = learner->node;
    ask(std::move(one));
  }
}

void PanelModel::askTables(PanelRequest request) {
  const LearnerStatus* const learner = tableLearner();
  if (learner == nullptr) return;
  request.node = learner->node;
  request.number = tableAgent();
  ask(std::move(request));
}

void PanelModel::setMode(const std::string& mode) { askLearners({Kind::SET_MODE, {}, mode}); }

void PanelModel::setParameter(const std::string& name, double value) {
  askLearners({Kind::SET_PARAMETER, {}, name, value});
}

void PanelModel::saveTable(const std::string& file, bool overwrite) {
  askTables({Kind::SAVE_TABLE, {}, file, 0.0, overwrite});
}

void PanelModel::loadTable(const std::string& file) { askTables({Kind::LOAD_TABLE, {}, file}); }

void PanelModel::shareTable(const std::string& method) { askTables({Kind::SHARE_TABLE, {}, method}); }

std::vector<PanelRequest> PanelModel::takeRequests() {
  std::vector<PanelRequest> ready;
  std::vector<PanelRequest> left;
  for (PanelRequest& request : waiting_) {
    const auto blocks = [&](const PanelRequest& other) { return areOfOneLine(other, request); };
    const bool waits = std::any_of(running_.begin(), running_.end(), blocks);
    if (!waits) running_.push_back(request);
    (waits ? left : ready).push_back(std::move(request));
  }
  waiting_ = std::move(left);
  return ready;
}

const PanelRequest* PanelModel::findPending(const PanelRequest& like) const {
  const auto is_it = [&](const PanelRequest& one) {
    return one.kind == like.kind && one.node == like.node && (like.text.empty() || one.text == like.text);
  };
  const auto waiting = std::find_if(waiting_.begin(), waiting_.end(), is_it);
  if (waiting != waiting_.end()) return &*waiting;
  const auto running = std::find_if(running_.begin(), running_.end(), is_it);
  return running != running_.end() ? &*running : nullptr;
}

double PanelModel::wanted(const PanelRequest& like, double present) const {
  const PanelRequest* const pending = findPending(like);
  return pending != nullptr ? pending->number : present;
}

bool PanelModel::isPending(Kind kind) const {
  const auto is_it = [&](const PanelRequest& request) { return request.kind == kind; };
  return std::any_of(running_.begin(), running_.end(), is_it) || std::any_of(waiting_.begin(), waiting_.end(), is_it);
}

std::string PanelModel::learnerEntry() const {
  if (learners_.count(learner_) > 0) return learner_;
  if (learners_.size() > 1) return ALL_LEARNERS;
  return learners_.empty() ? "" : learners_.begin()->first;
}

std::vector<const LearnerStatus*> PanelModel::learners() const {
  const std::string entry = learnerEntry();
  std::vector<const LearnerStatus*> chosen;
  std::vector<const LearnerStatus*> present;
  for (const auto& [node, learner] : learners_) {
    if (entry != ALL_LEARNERS && entry != node) continue;
    chosen.push_back(&learner);
    if (isReachable(node)) present.push_back(&learner);
  }
  return present.empty() ? chosen : present;
}

const LearnerStatus* PanelModel::tableLearner() const {
  const std::vector<const LearnerStatus*> chosen = learners();
  if (chosen.empty()) return nullptr;
  const auto found = std::find_if(chosen.begin(), chosen.end(),
                                  [&](const LearnerStatus* learner) { return serves(*learner, chosen_agent_); });
  return found != chosen.end() ? *found : chosen.front();
}

double PanelModel::tableAgent() const {
  const LearnerStatus* const learner = tableLearner();
  const bool is_meant = learner != nullptr && hasOwnTables(*learner) && serves(*learner, chosen_agent_);
  return is_meant ? static_cast<double>(std::max<std::int64_t>(0, chosen_agent_)) : 0.0;
}

double PanelModel::decisionRate(double now) const {
  const bool rests = status_.paused != 0 && !isPending(Kind::STEP);
  const auto is_recent = [&](const auto& sample) { return now - sample.first <= RATE_PERIOD; };
  const auto first = std::find_if(decisions_.begin(), decisions_.end(), is_recent);
  if (rests || first == decisions_.end() || now <= first->first) return 0.0;
  return static_cast<double>(decisions_.back().second - first->second) / (now - first->first);
}

std::string PanelModel::stateText() const {
  if (!isReachable(controller_)) return controller_ + " is away";
  if (!has_status_) return "waiting for " + controller_;
  if (isPending(Kind::STEP)) return "stepping";
  return status_.paused != 0 ? "paused" : "walking";
}

void PanelModel::showController(PanelView& view, double now) const {
  view.state = stateText();
  if (!isReachable(controller_) || !has_status_) return;
  view.has_controller = true;
  view.can_play = status_.paused != 0;
  view.can_pause = !view.can_play;
  view.can_step = view.can_play && !isPending(Kind::STEP);
  view.speed = wanted({Kind::SET_SPEED, controller_}, status_.real_time_factor);
  view.scenario = status_.scenario;
  view.episode = countText(status_.episode);
  view.tick = countText(status_.tick) + " (" + timeText(status_.time) + ")";
  view.success = shareText(status_.arrived, status_.agents);
  view.contact = shareText(status_.touched, status_.agents);
  view.collision = shareText(status_.collided, status_.agents);
  view.decisions = countText(static_cast<std::uint64_t>(std::llround(decisionRate(now))));
  view.missing = agentsText(status_.unanswered);
  if (status_.missed_answers > 0) view.missing += "; " + countText(status_.missed_answers) + " answers missed";
}

void PanelModel::showLearner(PanelView& view) const {
  if (learners_.size() > 1) view.learners.emplace_back(ALL_LEARNERS);
  for (const auto& [node, learner] : learners_) view.learners.push_back(node);
  view.learner = learnerEntry();
  const LearnerStatus* const learner = tableLearner();
  if (learner == nullptr) return;
  view.has_learner = isReachable(learner->node);
  view.can_share = view.has_learner && (hasOwnTables(*learner) || learners_.size() > 1);
  const PanelRequest* const mode = findPending({Kind::SET_MODE, learner->node});
  view.mode = mode != nullptr ? mode->text : learner->mode;
  view.epsilon = wanted({Kind::SET_PARAMETER, learner->node, "epsilon"}, learner->epsilon);
  view.alpha = wanted({Kind::SET_PARAMETER, learner->node, "alpha"}, learner->alpha);
  view.gamma = wanted({Kind::SET_PARAMETER, learner->node, "gamma"}, learner->gamma);
  view.table = !view.has_learner ? learner->node + " is away"
                                 : countText(learner->visited_rows) + " of " + countText(learner->rows) +
                                       " rows visited, " + countText(learner->decisions) + " decisions";
}

PanelView PanelModel::view(double now) const {
  PanelView view;
  showController(view, now);
  showLearner(view);
  if (learners_.empty()) view.table = "no learner";
  view.scenarios = scenarios_;
  view.has_markers = isReachable(markers_);
  view.chosen_agent =
      static_cast<std::int64_t>(wanted({Kind::CHOOSE_AGENT, markers_}, static_cast<double>(chosen_agent_)));
  view.message = message_;
  view.is_error = is_error_;
  return view;
}

}  // namespace crowd
