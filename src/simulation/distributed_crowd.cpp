#include "social_crowd/simulation/distributed_crowd.h"

#include <algorithm>

#include "simulation/agent_transfer.h"
#include "simulation/stopwatch.h"
#include "social_crowd/common/numbers.h"
#include "social_crowd/simulation/byte_archive.h"
#include "social_crowd/simulation/trajectory.h"
#include "social_crowd/simulation/walking_floor.h"
#include "social_crowd/world/population.h"

namespace crowd {
namespace {

constexpr double MARGIN = 1e-3;     // for rounding [m]
constexpr double CHAIN_ROOM = 3.0;  // length of a chain of impacts that copies allow for [m]

std::vector<Vector2> startsOf(const Scene& scene) {
  std::vector<Vector2> places;
  places.reserve(scene.agents.size());
  for (const AgentStart& start : scene.agents) places.push_back(start.position);
  return places;
}

}  // namespace

std::string indivisiblePart(const Scene& scene) {
  if (scene.order == Order::SEQUENTIAL) return "the order 'sequential'";
  if (!scene.robots.empty()) return "robots";
  if (scene.population && !scene.population->empty()) return "sources, sinks, routes, queues or gates";
  const auto waits = [](const AgentStart& start) { return start.route || start.reaction_time > 0.0; };
  if (std::any_of(scene.agents.begin(), scene.agents.end(), waits)) return "routes or reaction times";
  double radius = 0.0;
  for (const AgentStart& start : scene.agents) radius = std::max(radius, start.radius);
  Scene floor = scene;
  floor.agents.clear();
  const bool finds_ways = scene.way_finding && radius > 0.0;
  if (finds_ways && hasBarriers(walkingFloor(World(floor), radius))) {
    return "way-finding round walls or obstacles (way_finding: false leaves it out)";
  }
  return "";
}

DistributedCrowd::Reach::Reach(const Scene& scene, const Vision& vision, double ticks) {
  double speed = 0.0;
  double radius = 0.0;
  for (const AgentStart& start : scene.agents) {
    speed = std::max(speed, start.max_speed);
    radius = std::max(radius, start.radius);
  }
  for (const Obstacle& obstacle : scene.obstacles) {  // agents that are pushed are as fast
    speed = std::max({speed, obstacle.path.speed(), obstacle.path.velocity(0.0).norm()});
  }
  const double step = scene.tick_duration * speed;
  const double wandering = 2.0 * ticks * step;  // of own agents and of others until the next regroup()
  touching = 2.0 * (radius + step) + wandering + MARGIN;
  const double measured = scene.collision_radius + 2.0 * (radius + step);
  copies = std::max({vision.radius + radius + wandering, measured + wandering, touching + CHAIN_ROOM}) + MARGIN;
}

Scene DistributedCrowd::ownPart(const Scene& scene, const FloorStrips& strips, int rank, std::vector<AgentId>& names) {
  Scene part = scene;
  part.agents.clear();
  for (std::size_t i = 0; i < scene.agents.size(); ++i) {
    if (strips.stripOf(scene.agents[i].position) != rank) continue;
    part.agents.push_back(scene.agents[i]);
    names.push_back(static_cast<AgentId>(i));
  }
  return part;
}

DistributedCrowd::DistributedCrowd(const Scene& scene, std::uint64_t episode, const Learner& learner,
                                   ThreadPool& thread_pool, Communicator& communicator, const Options& options)
    : scenario_(scene.name),
      max_ticks_(scene.max_ticks),
      agent_count_(scene.agents.size()),
      episode_(episode),
      options_(options),
      reach_(scene, learner.model().vision(), static_cast<double>(options.regroup_ticks)),
      learner_(learner),
      vision_(learner.model().vision()),
      thread_pool_(thread_pool),
      communicator_(communicator),
      strips_(startsOf(scene), communicator.size()),
      part_(ownPart(scene, strips_, communicator.rank(), names_)),
      world_(part_),
      monitor_(part_, world_),
      border_(communicator) {
  part_ = Scene();
}

bool DistributedCrowd::step(bool stop) {
  const Stopwatch whole(CLOCK_MONOTONIC, seconds_);
  const std::uint64_t sent = communicator_.sentBytes();
  if (world_.tick() >= max_ticks_) return false;
  if (world_.tick() >= next_regroup_) regroup();
  {
    const Stopwatch busy(CLOCK_THREAD_CPUTIME_ID, busy_seconds_);
    crowd_.decide(world_, episode_, vision_, learner_, actions_, thread_pool_, &names_);
  }
  std::vector<std::uint64_t> sums = {actions_.size(), stop ? 1U : 0U};
  communicator_.sum(sums);
  was_stopped_ = sums[1] > 0;
  if (sums[0] == 0 || was_stopped_) return false;
  border_.exchangeActions(actions_);
  {
    const Stopwatch busy(CLOCK_THREAD_CPUTIME_ID, busy_seconds_);
    world_.beginStep(actions_, thread_pool_);
  }
  if (world_.contact() == Contact::SOLID) agreeOnSolidMotion();
  {
    const Stopwatch busy(CLOCK_THREAD_CPUTIME_ID, busy_seconds_);
    world_.endStep(thread_pool_);
    monitor_.observe(world_, thread_pool_);
  }
  bytes_ += communicator_.sentBytes() - sent;
  return true;
}

void DistributedCrowd::agreeOnSolidMotion() {
  std::vector<std::uint64_t> different = {border_.exchangeOutcomes(world_)};
  communicator_.sum(different);
  if (different.front() > 0) moveWholeCrowd();
}

void DistributedCrowd::appendTrajectoryRows(std::string& rows) {
  std::vector<Communicator::Bytes> out(rankCount());
  std::vector<Communicator::Bytes> in;
  ByteWriter write(out.front());
  for (const Agent& agent : world_.agents()) {
    if (!agent.perceives || !hasTrajectoryRow(agent, world_)) continue;
    write(names_[agent.id]);
    write(agent.pose.position);
  }
  communicator_.exchangeAnySize(out, in);
  if (rank() != 0) return;
  in.front() = std::move(out.front());
  std::vector<std::pair<AgentId, Vector2>> places;
  for (const Communicator::Bytes& message : in) {
    ByteReader read(message);
    while (!read.isAtEnd()) {
      auto& [name, place] = places.emplace_back();
      read(name);
      read(place);
    }
  }
  std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [name, place] : places) appendTrajectoryRow(episode_, world_.tick(), name, place, rows);
}

EpisodeResult DistributedCrowd::result() {
  std::vector<Communicator::Bytes> out(rankCount());
  std::vector<Communicator::Bytes> in;
  ByteWriter write(out.front());
  const auto add = [&](AgentId name, const AgentResult& agent) {
    write(name);
    transferResult(write, agent);
  };
  for (const Finished& finished : finished_) add(finished.name, finished.result);
  for (const Agent& agent : world_.agents()) {
    if (agent.perceives) add(names_[agent.id], monitor_.resultOf(monitor_.tracks()[agent.id]));
  }
  communicator_.exchangeAnySize(out, in);
  EpisodeResult result;
  result.scenario = scenario_;
  result.ticks = world_.tick();
  if (rank() != 0) return result;
  in.front() = std::move(out.front());
  result.agents.resize(agent_count_);
  for (const Communicator::Bytes& message : in) {
    ByteReader read(message);
    while (!read.isAtEnd()) {
      AgentId name = 0;
      read(name);
      transferResult(read, result.agents[name]);
    }
  }
  return result;
}

RanksReport DistributedCrowd::report() {
  Communicator::Bytes bytes;
  ByteWriter write(bytes);
  write(busy_seconds_);
  std::vector<std::uint64_t> sent = {bytes_};
  communicator_.sum(sent);
  double slowest = 0.0;
  double sum = 0.0;
  for (const Communicator::Bytes& other : communicator_.gatherAll(bytes)) {
    ByteReader read(other);
    double seconds = 0.0;
    read(seconds);
    slowest = std::max(slowest, seconds);
    sum += seconds;
  }
  RanksReport report;
  report.ranks = communicator_.size();
  report.agents = agent_count_;
  report.ticks = world_.tick();
  report.seconds = seconds_;
  report.bytes = sent.front();
  report.busy_seconds = slowest;
  report.agent_imbalance = divisions_ > 0 ? imbalance_sum_ / static_cast<double>(divisions_) : 1.0;
  report.time_imbalance = sum > 0.0 ? slowest * static_cast<double>(rankCount()) / sum : 1.0;
  report.whole_motions = whole_motions_;
  return report;
}

std::string RanksReport::text() const {
  const double each = 1.0 / static_cast<double>(std::max<std::uint64_t>(1, ticks));
  std::string text = std::to_string(ranks) + " ranks, " + std::to_string(agents) + " agents, " + std::to_string(ticks) +
                     " ticks: " + toFixedText(1e3 * seconds * each, 2) + " ms per tick (" +
                     toFixedText(1e3 * busy_seconds * each, 2) + " ms computing on the slowest rank), " +
                     toFixedText(1e-6 * static_cast<double>(bytes) * each, 3) + " MB exchanged per tick";
  text +=
      ", imbalance of agents " + toFixedText(agent_imbalance, 3) + ", of computing " + toFixedText(time_imbalance, 3);
  if (whole_motions > 0) text += ", " + std::to_string(whole_motions) + " ticks with the motion of the whole crowd";
  return text;
}

}  // namespace crowd
