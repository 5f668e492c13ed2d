#include "ranks/distributed_crowd.h"

#include <algorithm>

#include "navigation/walking_floor.h"
#include "scenario/population_spec.h"
#include "simulation/agent_transfer.h"
#include "simulation/byte_archive.h"
#include "simulation/evaluation/trajectory.h"
#include "simulation/stopwatch.h"

namespace crowd {
namespace {

constexpr double ROUNDING_MARGIN = 1e-3;  // for rounding [m]
constexpr double CHAIN_ROOM = 3.0;        // length of a chain of impacts that copies allow for [m]

std::vector<Vector2> startsOf(const Scene& scene) {
  std::vector<Vector2> places;
  places.reserve(scene.agents.size());
  for (const AgentStart& start : scene.agents) places.push_back(start.position);
  return places;
}

}  // namespace

bool isDivisible(const Scene& scene) {
  if (scene.order == Order::SEQUENTIAL || !scene.robots.empty()) return false;
  if (scene.population && !scene.population->empty()) return false;
  const auto depends = [](const AgentStart& start) {
    return start.route || start.reaction_time > 0.0 || start.group != NO_GROUP;
  };
  if (std::any_of(scene.agents.begin(), scene.agents.end(), depends)) return false;
  double radius = 0.0;
  for (const AgentStart& start : scene.agents) radius = std::max(radius, start.radius);
  if (!scene.way_finding || radius == 0.0) return true;
  Scene floor = scene;
  floor.agents.clear();
  return !hasBarriers(walkingFloor(World(floor), radius));
}

DistributedCrowd::Reach::Reach(const Scene& scene, const Vision& vision, double ticks) {
  double speed = 0.0;
  double radius = 0.0;
  for (const AgentStart& start : scene.agents) {
    speed = std::max(speed, start.walkingSpeed());
    radius = std::max(radius, start.radius);
  }
  for (const Obstacle& obstacle : scene.obstacles) {  // agents that are pushed are as fast
    speed = std::max({speed, obstacle.path.speed(), obstacle.path.velocity(0.0).norm()});
  }
  const double step = scene.tick_duration * speed;
  const double wandering = 2.0 * ticks * step;  // of own agents and of others until the next regroup()
  touching = 2.0 * (radius + step) + wandering + ROUNDING_MARGIN;
  const double measured = scene.collision_radius + 2.0 * (radius + step);
  copies =
      std::max({vision.radius + radius + wandering, measured + wandering, touching + CHAIN_ROOM}) + ROUNDING_MARGIN;
}

Scene DistributedCrowd::ownPart(const Scene& scene, const FloorStrips& strips, int rank, std::vector<AgentId>& ids) {
  Scene part = scene;
  part.way_finding = false;
  part.agents.clear();
  for (std::size_t i = 0; i < scene.agents.size(); ++i) {
    if (strips.stripOf(scene.agents[i].position) != rank) continue;
    part.agents.push_back(scene.agents[i]);
    ids.push_back(static_cast<AgentId>(i));
  }
  return part;
}

DistributedCrowd::DistributedCrowd(const Scene& scene, std::uint64_t episode, Learner& learner, ThreadPool& thread_pool,
                                   Communicator& communicator, const Options& options)
    : scenario_(scene.name),
      max_ticks_(scene.max_ticks),
      agent_count_(scene.agents.size()),
      options_(options),
      reach_(scene, learner.model().vision(), static_cast<double>(options.regroup_ticks)),
      communicator_(communicator),
      strips_(startsOf(scene), communicator.size()),
      episode_(ownPart(scene, strips_, communicator.rank(), first_ids_), episode, learner.model().vision(),
               thread_pool),
      own_(learner, thread_pool),
      border_(communicator) {
  episode_.edit().replaceCrowd(agents_, tracks_);
  for (std::size_t i = 0; i < agents_.size(); ++i) agents_[i].id = first_ids_[i];
  episode_.edit().replaceCrowd(agents_, tracks_);
}

bool DistributedCrowd::step(bool stop) {
  const Stopwatch whole(CLOCK_MONOTONIC, seconds_);
  const std::uint64_t sent = communicator_.sentBytes();
  if (tick() >= max_ticks_) return false;
  if (tick() >= next_regroup_) regroup();
  stops_ = stop;
  const Stopwatch busy(CLOCK_THREAD_CPUTIME_ID, busy_seconds_);
  const bool has_walked = episode_.walk(*this);
  if (has_walked) bytes_ += communicator_.sentBytes() - sent;
  return has_walked;
}

bool DistributedCrowd::decide(Episode& episode, std::vector<AgentAction>& actions) {
  own_.decide(episode, actions);
  const Stopwatch waiting(CLOCK_THREAD_CPUTIME_ID, waiting_seconds_);
  std::vector<std::uint64_t> sums = {actions.size(), stops_ ? 1U : 0U};
  communicator_.sum(sums);
  was_stopped_ = sums[1] > 0;
  if (sums[0] == 0 || was_stopped_) return false;
  border_.exchangeActions(world(), actions);
  return true;
}

void DistributedCrowd::agree(World& world) {
  const Stopwatch waiting(CLOCK_THREAD_CPUTIME_ID, waiting_seconds_);
  std::vector<std::uint64_t> different = {border_.exchangeOutcomes(world)};
  communicator_.sum(different);
  if (different.front() > 0) moveWholeCrowd(world);
}

void DistributedCrowd::appendTrajectoryRows(std::string& rows) {
  std::vector<Communicator::Bytes> out(rankCount());
  std::vector<Communicator::Bytes> in;
  ByteWriter write(out.front());
  for (const Agent& agent : world().agents()) {
    if (!agent.perceives || !hasTrajectoryRow(agent, world())) continue;
    write(agent.id);
    write(agent.pose.position);
  }
  communicator_.exchangeAnySize(out, in);
  if (rank() != 0) return;
  in.front() = std::move(out.front());
  std::vector<std::pair<AgentId, Vector2>> places;
  for (const Communicator::Bytes& message : in) {
    ByteReader read(message);
    while (!read.isAtEnd()) {
      auto& [id, place] = places.emplace_back();
      read(id);
      read(place);
    }
  }
  std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [id, place] : places) appendTrajectoryRow(episode_.number(), tick(), id, place, rows);
}

EpisodeResult DistributedCrowd::result() {
  std::vector<Communicator::Bytes> out(rankCount());
  std::vector<Communicator::Bytes> in;
  ByteWriter write(out.front());
  const auto add = [&](AgentId id, const AgentResult& agent) {
    write(id);
    transferResult(write, agent);
  };
  const EpisodeMonitor& monitor = episode_.monitor();
  for (const Finished& finished : finished_) add(finished.id, finished.result);
  for (const Agent& agent : world().agents()) {
    if (agent.perceives) add(agent.id, monitor.resultOf(monitor.tracks()[agent.id]));
  }
  communicator_.exchangeAnySize(out, in);
  EpisodeResult result;
  result.scenario = scenario_;
  result.ticks = tick();
  if (rank() != 0) return result;
  in.front() = std::move(out.front());
  std::vector<AgentResult> agents(agent_count_);
  for (const Communicator::Bytes& message : in) {
    ByteReader read(message);
    while (!read.isAtEnd()) {
      AgentId id = 0;
      read(id);
      transferResult(read, agents[id]);
    }
  }
  result.agents = std::move(agents);
  return result;
}

RanksReport DistributedCrowd::report() {
  RanksReport report;
  report.agents = agent_count_;
  report.ticks = tick();
  report.seconds = seconds_;
  report.agent_imbalance = divisions_ > 0 ? imbalance_sum_ / static_cast<double>(divisions_) : 1.0;
  report.whole_motions = whole_motions_;
  report.collect(communicator_, busy_seconds_ - waiting_seconds_, bytes_);
  return report;
}

}  // namespace crowd
