#include "maps/map_file.h"

#include <filesystem>
#include <vector>

#include "common/text/enum_names.h"
#include "common/text/numbers.h"
#include "common/text/yaml_reader.h"
#include "maps/map_image.h"

namespace crowd {
namespace {

enum class MapMode { TRINARY, SCALE, RAW };

constexpr EnumNames<MapMode, 3> MAP_MODES("mode", {"trinary", "scale", "raw"});

/// How the pixels of an image become cells.
struct PixelRules {
  MapMode mode = MapMode::TRINARY;
  bool negate = false;
  double occupied_threshold = 0.0;
  double free_threshold = 0.0;
};

/// The occupancy of a pixel in a nav_msgs/OccupancyGrid: -1 or 0 to 100; in mode raw any value.
std::int8_t occupancyOf(const std::uint8_t* pixel, const MapImage& image, const PixelRules& rules) {
  const bool is_trinary = rules.mode == MapMode::TRINARY;
  const std::uint32_t count = image.hasAlpha() && !is_trinary ? image.channels - 1 : image.channels;
  std::uint32_t sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) sum += pixel[i];
  const double mean = static_cast<double>(sum) / count;
  const double brightness = rules.negate ? 255.0 - mean : mean;
  if (rules.mode == MapMode::RAW) return static_cast<std::int8_t>(static_cast<std::uint8_t>(brightness));
  const double darkness = (255.0 - brightness) / 255.0;
  if (darkness > rules.occupied_threshold) return 100;
  if (darkness < rules.free_threshold) return 0;
  if (is_trinary || (image.hasAlpha() && pixel[count] == 0)) return -1;
  const double share = (darkness - rules.free_threshold) / (rules.occupied_threshold - rules.free_threshold);
  return static_cast<std::int8_t>(1.0 + 98.0 * share);
}

/// Cells from the bottom row to the top row.
std::vector<CellState> cellsOf(const MapImage& image, const PixelRules& rules) {
  std::vector<CellState> cells;
  cells.reserve(std::size_t{image.width} * image.height);
  const std::size_t row_size = std::size_t{image.width} * image.channels;
  for (std::size_t row = image.height; row-- > 0;) {
    const std::uint8_t* const pixels = image.samples.data() + row * row_size;
    for (std::size_t i = 0; i < row_size; i += image.channels)
      cells.push_back(cellStateOf(occupancyOf(pixels + i, image, rules)));
  }
  return cells;
}

Pose readOrigin(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsSequence() || node.size() != 3) throwExpected(place, node, "[x, y, yaw]");
  const auto read = [&](std::size_t index) { return readNumber(node[index], place.element(index)); };
  const double x = read(0);
  const double y = read(1);
  return {{x, y}, read(2)};
}

/// map_server reads a number; true and false are common in hand-written files.
bool readNegate(const YAML::Node& node, const YamlPlace& place) {
  const std::string text = node.IsScalar() ? node.Scalar() : "";
  const bool yes = text == "1" || text == "true";
  if (!yes && text != "0" && text != "false") throwExpected(place, node, "0 or 1");
  return yes;
}

PixelRules readPixelRules(const YamlMap& map) {
  PixelRules rules;
  rules.mode = MAP_MODES.read(map, rules.mode);
  rules.negate = readNegate(map.need("negate"), map.placeOf("negate"));
  rules.occupied_threshold = map.number("occupied_thresh", NumberRule::FRACTION);
  rules.free_threshold = map.number("free_thresh", NumberRule::FRACTION);
  if (rules.free_threshold >= rules.occupied_threshold) {
    throwExpected(map.placeOf("free_thresh"), map.need("free_thresh"),
                  "a number below occupied_thresh, " + toText(rules.occupied_threshold));
  }
  return rules;
}

MapImage readImage(const YamlMap& map) {
  const std::string name = map.text("image");
  if (name.empty()) throwExpected(map.placeOf("image"), map.need("image"), "the file of an image");
  const std::filesystem::path folder = std::filesystem::path(map.place().file).parent_path();
  try {
    return readMapImage((folder / name).string());
  } catch (const Error& error) {
    throwProblem(map.placeOf("image"), map.need("image"), error.what());
  }
}

}  // namespace

OccupancyMap readMap(const std::string& yaml_file) {
  const std::vector<YAML::Node> documents = loadYamlStream(yaml_file);
  if (documents.size() != 1) {
    throw InputError(yaml_file + ": expected one YAML document, got " + std::to_string(documents.size()));
  }
  const YamlMap keys(documents.front(), {yaml_file, 0, ""},
                     {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"});
  OccupancyMap map;
  map.resolution = keys.number("resolution", NumberRule::POSITIVE);
  map.origin = readOrigin(keys.need("origin"), keys.placeOf("origin"));
  const PixelRules rules = readPixelRules(keys);
  const MapImage image = readImage(keys);
  map.width = image.width;
  map.height = image.height;
  map.cells = cellsOf(image, rules);
  const std::string problem = problemOf(map);
  if (!problem.empty()) throwProblem(keys.place(), keys.node(), problem);
  return map;
}

}  // namespace crowd
