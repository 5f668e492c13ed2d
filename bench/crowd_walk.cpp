#include "crowd_walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/random.h"
#include "learning/q_table_file.h"
#include "scenario/scenario.h"

namespace crowd {
namespace {

constexpr Range SPEEDS{0.9, 1.6};  // [m/s]
constexpr Range RADII{0.2, 0.3};   // [m]
constexpr int GOALS = 3;           // of each agent, in sequence: no agent arrives during a measurement

Vector2 drawPoint(KeyedRandom& random, double side) {
  const double x = random.uniform(0.0, side);
  return {x, random.uniform(0.0, side)};
}

/// Points of a square lattice with random displacements, in random order.
std::vector<Vector2> drawPlaces(const CrowdPlan& plan, KeyedRandom& random) {
  const double spacing = 1.0 / std::sqrt(plan.density);
  const double play = std::max(0.0, spacing / 2.0 - RADII.high);
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(plan.agents))));
  std::vector<Vector2> places;
  for (std::size_t i = 0; i < plan.agents; ++i) {
    const std::size_t row = i / columns;
    const Vector2 point(static_cast<double>(i % columns), static_cast<double>(row));
    const double x = random.uniform(-play, play);
    places.emplace_back(spacing * point + Vector2(x, random.uniform(-play, play)));
  }
  for (std::size_t left = places.size(); left > 1; --left) {
    std::swap(places[left - 1], places[random.below(static_cast<std::uint32_t>(left))]);
  }
  return places;
}

}  // namespace

Learner makeWalker() {
  TrainedTable trained = loadQTable(SOURCE_DIR "/config/q_tables/anticipation.txt");
  Learner::Options options;
  options.mode = Mode::DEMO;
  options.plan.parameters = trained.parameters;
  return {trained.model, options, std::move(trained.table)};
}

Scene makeCrowd(const CrowdPlan& plan) {
  KeyedRandom random(1, KeyedRandom::PLACEMENT, {plan.agents});
  Scene scene;
  scene.name = "crowd";
  scene.max_ticks = UINT64_MAX;
  scene.goal_tolerance = 0.3;
  scene.motion = plan.motion;
  const double side = std::sqrt(static_cast<double>(plan.agents) / plan.density);
  for (const Vector2& place : drawPlaces(plan, random)) {
    AgentStart& agent = scene.agents.emplace_back();
    agent.position = place;
    for (int i = 0; i < GOALS; ++i) agent.goals.push_back(drawPoint(random, side));
    const Vector2 way = agent.goals.front() - place;
    agent.heading = std::atan2(way.y(), way.x());
    agent.max_speed = SPEEDS.draw(random);
    agent.radius = RADII.draw(random);
  }
  return scene;
}

CrowdWalk::CrowdWalk(const CrowdPlan& plan) : CrowdWalk(makeCrowd(plan), plan.vision_radius, plan.threads) {}

CrowdWalk::CrowdWalk(const Scene& scene, double vision_radius, unsigned threads)
    : world_(scene),
      learner_(makeWalker()),
      vision_(learner_.model().vision()),
      thread_pool_(threads),
      decider_(learner_, thread_pool_) {
  vision_.radius = vision_radius;
  if (scene.motion) world_.setMotion(*scene.motion);
  way_finder_.update(world_);
}

std::size_t CrowdWalk::step() {
  decider_.decideInBlocks(world_, 0, vision_, actions_);
  world_.step(actions_, thread_pool_);
  way_finder_.update(world_);
  return actions_.size();
}

}  // namespace crowd
