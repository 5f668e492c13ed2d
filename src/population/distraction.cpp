#include "population/distraction.h"

#include <algorithm>

#include "common/portable_math.h"
#include "scenario/population_spec.h"

namespace crowd {

void Distraction::add(AgentId id, const PauseDescription& pauses, double time) {
  Person& person = people_.emplace_back(Person{id, pauses, {seed_, KeyedRandom::DISTRACTION, {id}}, time});
  person.next_change += drawInterval(person);
}

void Distraction::update(World& world) {
  const auto is_gone = [&](const Person& person) { return !world.isActive(person.id); };
  people_.erase(std::remove_if(people_.begin(), people_.end(), is_gone), people_.end());
  for (Person& person : people_) {
    if (person.next_change > world.time() + TIME_ROUNDING) continue;
    while (person.next_change <= world.time() + TIME_ROUNDING) {
      person.is_distracted = !person.is_distracted;
      person.next_change += drawInterval(person);
    }
    apply(person, world);
  }
}

void Distraction::end(AgentId id, World& world) {
  const auto is_it = [id](const Person& person) { return person.id == id; };
  const auto found = std::find_if(people_.begin(), people_.end(), is_it);
  if (found == people_.end()) return;
  found->is_distracted = false;
  apply(*found, world);
  people_.erase(found);
}

/// Draws the time from now on until the person is distracted or attentive again [s].
double Distraction::drawInterval(Person& person) {
  if (person.is_distracted) return person.pauses.duration.draw(person.random);
  return -portable::log(1.0 - person.random.uniform()) * person.pauses.every;
}

void Distraction::apply(const Person& person, World& world) {
  Agent& agent = world.walkingAgent(person.id);
  if (person.pauses.speed > 0.0) {
    agent.setPace(Pace::DISTRACTION, person.is_distracted ? person.pauses.speed : 1.0);
  } else {
    agent.setHeld(Hold::PAUSE, person.is_distracted);
  }
}

}  // namespace crowd
