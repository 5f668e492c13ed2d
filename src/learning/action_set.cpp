#include "social_crowd/learning/action_set.h"

#include "social_crowd/learning/kings_moves.h"

namespace crowd {

std::shared_ptr<const ActionSet> makeActionSet(const YAML::Node& node, const YamlPlace& place) {
  YamlMap map(node, place);
  const std::string type = map.text("type");
  if (type != KingsMoves::TYPE) throwExpected(map.placeOf("type"), map.need("type"), "kings_moves");
  const auto rotations = static_cast<int>(map.whole("rotations", 2, 360, KingsMoves::DEFAULT_ROTATIONS));
  map.finish();
  return std::make_shared<KingsMoves>(rotations);
}

}  // namespace crowd
