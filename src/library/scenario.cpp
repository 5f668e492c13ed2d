#include "social_crowd/scenario.h"

#include "scenario/reading/scenario_files.h"
#include "scenario/reading/scenario_reader.h"

namespace crowd::library {

Scenario Scenario::load(const std::string& name_or_file) {
  return Scenario(std::make_shared<ScenarioList>(readScenarios(findScenario(name_or_file))));
}

Scenario Scenario::parse(const std::string& text, const std::string& name) {
  return Scenario(std::make_shared<ScenarioList>(parseScenarios(text, name)));
}

std::vector<std::string> Scenario::names() { return scenarioNames(); }
std::size_t Scenario::size() const { return list_->size(); }

}  // namespace crowd::library
