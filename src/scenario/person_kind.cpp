#include "scenario/person_kind.h"

#include "scenario/shares.h"

namespace crowd {
namespace {

constexpr int NORMAL_TRIES = 100;

}  // namespace

double Distribution::draw(KeyedRandom& random) const {
  for (int tries = 0; normal && tries < NORMAL_TRIES; ++tries) {
    const double value = normal->mean + normal->deviation * random.normal();
    if (value >= range.low && value <= range.high) return value;
  }
  return range.draw(random);  // within a range much narrower than the deviation a normal density is uniform
}

void drawKind(const AgentGroup& group, const std::vector<PersonKind>& kinds, KeyedRandom random, AgentStart& start) {
  if (group.kinds.empty()) return;
  const std::size_t number = drawShare(group.kinds, random).kind;
  const PersonKind& kind = kinds[number];
  start.kind = static_cast<std::int32_t>(number);
  start.figure = kind.figure;
  const double radius = kind.radius.draw(random);
  if (group.radius_of_kind) start.radius = radius;
  if (group.speed_of_kind) start.max_speed = kind.speed.draw(random);
}

void drawReaction(const AgentGroup& group, KeyedRandom random, AgentStart& start) {
  if (!group.reactions.empty()) start.reaction = drawShare(group.reactions, random).reaction;
}

}  // namespace crowd
