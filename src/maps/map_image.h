#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace crowd {

/// @brief An image of a map; its top row comes first.
struct MapImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t channels = 1;         ///< per pixel; 1: gray, 3: red, green, blue, 4: the same and opacity
  std::vector<std::uint8_t> samples;  ///< pixel by pixel, 0: black or transparent

  bool hasAlpha() const { return channels == 4; }
};

/// @brief Reads a PGM or PNG file; its first bytes tell which of them it is. Samples are scaled to 0 to 255.
/// @throws FileError if the file cannot be read, InputError if its content is not valid; both name the file
MapImage readMapImage(const std::string& file);

/// @brief Parses a PGM image (P2 or P5) with samples up to 65535. @throws InputError without the name of the file
MapImage parsePgm(std::string_view content);

/// @brief Decodes a PNG image. @throws InputError without the name of the file
MapImage decodePng(std::string_view content);

/// @brief Throws InputError unless an image of this size has pixels, and no more than a map may have cells.
void requireImageSize(std::uint32_t width, std::uint32_t height);

}  // namespace crowd
