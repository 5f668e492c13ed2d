// Checks of received perceptions.

#include <cmath>
#include <string>

#include "ros/messages/tick_messages.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

void checkPart(std::uint32_t first, std::uint32_t count, std::size_t size, const char* what) {
  if (std::uint64_t{first} + count <= size) return;
  throw InputError(std::string("perceptions: the ") + what + " of an agent are beyond the end of the list of " +
                   std::to_string(size));
}

void checkNumbers(const AgentPerception& self) {
  const bool finite = std::isfinite(self.goal.x()) && std::isfinite(self.goal.y()) && std::isfinite(self.max_speed) &&
                      std::isfinite(self.radius);
  if (!finite)
    throw InputError("perceptions: goal, max_speed or radius of agent " + std::to_string(self.agent) +
                     " is not a finite number");
  if (self.agent >= AGENT_LIMIT) throw InputError("perceptions: invalid agent number " + std::to_string(self.agent));
}

}  // namespace

void requireValid(const Perceptions& perceptions) {
  const std::string refusal = refusalOf(perceptions.motion);
  if (!refusal.empty()) throw InputError("perceptions: " + refusal);
  for (const AgentPerception& self : perceptions.agents) {
    checkNumbers(self);
    checkPart(self.first_neighbour, self.neighbour_count, perceptions.neighbours.size(), "neighbours");
    checkPart(self.first_wall, self.wall_count, perceptions.walls.size(), "walls");
  }
}

}  // namespace crowd
