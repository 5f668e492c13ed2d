#pragma once

#include <gtest/gtest.h>

#include <string>

#include "scenario/reading/scenario_reader.h"
#include "social_crowd/errors.h"

/// Texts of scenarios, and the scenes and errors of the reader.
namespace crowd::scenario_texts {

const char* const HEAD = "name: n\nduration: 60\ngoal_tolerance: 0.3\n";  // lines 1 to 3
const char* const AGENT = "{position: [0, 0], goal: [4, 3], speed: 1.3, radius: 0.25}";
const char* const AGENTS = "agents: [{position: [0, 0], goal: [4, 3], speed: 1.3, radius: 0.25}]\n";  // line 4

inline std::string errorOf(const std::string& text) {
  try {
    parseScenarios(text, "s.yaml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

/// The error message about a scenario whose only agent has these entries.
inline std::string agentError(const std::string& entries) {
  return errorOf(std::string(HEAD) + "agents:\n  - {" + entries + "}\n");
}

inline std::string obstacleError(const std::string& entries) {
  return errorOf(std::string(HEAD) + AGENTS + "obstacles:\n  - {" + entries + "}\n");
}

inline Scene sceneOf(const std::string& text) { return parseScenarios(text, "s.yaml").scene(1, 0); }

inline Obstacle obstacleOf(const std::string& entries) {
  return sceneOf(std::string(HEAD) + AGENTS + "obstacles: [{" + entries + "}]\n").obstacles.at(0);
}

inline void expectNear(const Vector2& value, const Vector2& expected) {
  EXPECT_NEAR(value.x(), expected.x(), 1e-12);
  EXPECT_NEAR(value.y(), expected.y(), 1e-12);
}

}  // namespace crowd::scenario_texts
