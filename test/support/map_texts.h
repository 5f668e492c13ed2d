#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "maps/map_file.h"
#include "support/temporary_folder.h"

/// Map files for tests.
namespace crowd::map_texts {

/// Bytes of samples.
inline std::string bytes(const std::vector<int>& values) {
  std::string text;
  for (const int value : values) text += static_cast<char>(value);
  return text;
}

/// The usual keys and values of a map file; keys can be replaced, added, and removed (empty value).
class Keys {
 public:
  Keys& set(const std::string& key, const std::string& value) {
    const auto line = std::find_if(lines_.begin(), lines_.end(), [&](const Line& each) { return each.key == key; });
    if (line != lines_.end()) {
      line->value = value;
    } else {
      lines_.push_back({key, value});
    }
    return *this;
  }
  std::string text() const {
    std::string text;
    for (const Line& line : lines_) text += line.value.empty() ? "" : line.key + ": " + line.value + "\n";
    return text;
  }

 private:
  struct Line {
    std::string key;
    std::string value;
  };
  std::vector<Line> lines_ = {{"image", "map.pgm"},        {"resolution", "0.05"},   {"origin", "[-1, 2, 0.5]"},
                              {"occupied_thresh", "0.65"}, {"free_thresh", "0.196"}, {"negate", "0"}};
};

/// One row of six pixels: black, dark, medium, the gray that map_server writes for unknown cells, light, and white.
inline const std::vector<int> GRAYS = {0, 80, 127, 205, 210, 255};

inline std::string pgmOf(const std::vector<int>& samples) {
  return "P5 " + std::to_string(samples.size()) + " 1 255\n" + bytes(samples);
}

/// The map of these keys and this content of its image, map.pgm.
inline OccupancyMap read(const Keys& keys, const std::string& image) {
  const TemporaryFolder folder;
  folder.write("map.pgm", image);
  return readMap(folder.write("map.yaml", keys.text()));
}

/// The cells of a map: '.' free, '#' occupied, '?' unknown, its bottom row first.
inline std::string drawingOf(const OccupancyMap& map) {
  std::string text;
  for (const CellState cell : map.cells) text += ".#?"[static_cast<std::size_t>(cell)];
  return text;
}

}  // namespace crowd::map_texts
