// The names that JavaScript sees.

#include <emscripten/bind.h>

#include <memory>
#include <string>
#include <vector>

#include "social_crowd/scenario.h"
#include "wasm/guarded.h"
#include "wasm/wasm_crowd.h"

using crowd::wasm::Guarded;
using crowd::wasm::WasmCrowd;
using emscripten::val;

namespace {

std::unique_ptr<WasmCrowd> makeCrowd(const std::string& scenario, const std::string& table, double seed,
                                     double episode) {
  return crowd::wasm::guarded([&] { return std::make_unique<WasmCrowd>(scenario, table, seed, episode); });
}

val scenarioNames() {
  return crowd::wasm::guarded([] { return val::array(crowd::library::Scenario::names()); });
}

}  // namespace

EMSCRIPTEN_BINDINGS(social_crowd) {
  emscripten::function("scenarioNames", &scenarioNames);
  emscripten::class_<WasmCrowd>("Crowd")
      .constructor(&makeCrowd)
      .function("step", &Guarded<&WasmCrowd::step>::call)
      .function("isOver", &WasmCrowd::isOver)
      .function("tick", &WasmCrowd::tick)
      .function("time", &WasmCrowd::time)
      .function("tickDuration", &WasmCrowd::tickDuration)
      .function("arrived", &WasmCrowd::arrived)
      .function("agents", &WasmCrowd::agents)
      .function("walls", &WasmCrowd::walls)
      .function("obstacles", &WasmCrowd::obstacles)
      .function("robots", &WasmCrowd::robots)
      .function("map", &WasmCrowd::map)
      .function("mind", &Guarded<&WasmCrowd::mind>::call)
      .function("addAgent", &Guarded<&WasmCrowd::addAgent>::call)
      .function("removeAgent", &Guarded<&WasmCrowd::removeAgent>::call)
      .function("setGoal", &Guarded<&WasmCrowd::setGoal>::call)
      .function("addObstacle", &Guarded<&WasmCrowd::addObstacle>::call)
      .function("removeObstacle", &Guarded<&WasmCrowd::removeObstacle>::call)
      .function("addWall", &Guarded<&WasmCrowd::addWall>::call)
      .function("removeWall", &Guarded<&WasmCrowd::removeWall>::call);
}
