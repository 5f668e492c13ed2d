#include "navigation/sized_floor.h"

#include <cmath>
#include <set>
#include <utility>

#include "scenario/population_spec.h"

namespace crowd {
namespace {

std::set<double> sizesOf(const World& world, const WorldChange& change, const Scene& scene) {
  std::set<double> sizes;
  const auto add = [&](double radius) { sizes.insert(SizedFloor::sizeOf(radius)); };
  for (const Agent& agent : world.agents()) add(agent.radius);
  if (change.agent != nullptr) add(change.agent->radius);
  if (!scene.population) return sizes;
  for (const SourceDescription& source : scene.population->sources) {
    const auto& radius = source.agents.radius;
    for (double some = radius.low; some < radius.high; some += SizedFloor::SIZE_STEP) add(some);
    add(radius.high);
  }
  return sizes;
}

}  // namespace

double SizedFloor::sizeOf(double radius) {
  constexpr double ROUNDING = 1e-6;  // of radii that are multiples of the step [steps]
  return SIZE_STEP * std::ceil(radius / SIZE_STEP - ROUNDING);
}

SizedFloor::SizedFloor(const World& world, double size, const FloorPlan::Bounds& bounds,
                       const std::vector<Segment>& gates)
    : size_(size) {
  FloorPlan floor = walkingFloor(world, size);
  floor.bounds = bounds;
  data_ = navigationData(floor, size, world.stopRequest());
  if (openGates(gates, floor)) opened_ = std::move(floor);
}

NavigationMesh::Query& SizedFloor::comfortable() {
  return comfortable_ ? *comfortable_ : comfortable_.emplace(data_->comfortable);
}

NavigationMesh::Query& SizedFloor::tight() { return tight_ ? *tight_ : tight_.emplace(data_->tight); }

NavigationMesh::Query& SizedFloor::open(const StopRequest& stop) {
  return open_ ? *open_ : open_.emplace(navigationData(*opened_, size_, stop)->tight);
}

void requireNavigableFloor(const World& world, const WorldChange& change, const Scene& scene) {
  for (const double size : sizesOf(world, change, scene)) {
    const FloorPlan floor = walkingFloor(world, size, change);
    if (hasBarriers(floor)) navigationData(floor, size, world.stopRequest());
  }
}

}  // namespace crowd
