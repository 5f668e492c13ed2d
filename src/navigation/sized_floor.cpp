#include "navigation/sized_floor.h"

#include <set>
#include <utility>

#include "scenario/population_spec.h"

namespace crowd {
namespace {

std::set<double> sizesOf(const World& world, const WorldChange& change, const Scene& scene) {
  std::set<double> sizes;
  const auto add = [&](double radius) { sizes.insert(sizeOf(radius)); };
  for (const Agent& agent : world.agents()) add(agent.radius);
  if (change.agent != nullptr) add(change.agent->radius);
  if (!scene.population) return sizes;
  for (const SourceDescription& source : scene.population->sources) {
    add(source.agents.radius.low);
    add(source.agents.radius.high);
    for (const KindShare& each : source.agents.kinds) add(scene.population->kinds[each.kind].radius.high);
  }
  return sizes;
}

}  // namespace

SizedFloor::SizedFloor(FloorPlan floor, double size, const std::vector<Segment>& gates, const StopRequest& stop)
    : size_(size), data_(navigationData(floor, size, stop)) {
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
  const std::set<double> sizes = sizesOf(world, change, scene);
  if (sizes.empty()) return;
  const std::optional<FloorPlan::Bounds> bounds = walkingFloor(world, *sizes.rbegin(), change).bounds;
  for (const double size : sizes) {
    FloorPlan floor = walkingFloor(world, size, change);
    floor.bounds = bounds;
    if (hasBarriers(floor)) navigationData(floor, size, world.stopRequest());
  }
}

}  // namespace crowd
