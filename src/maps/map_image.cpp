#include "maps/map_image.h"

#include "common/files/files.h"
#include "geometry/limits.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

bool startsWith(std::string_view content, std::string_view magic) { return content.substr(0, magic.size()) == magic; }

MapImage parseImage(std::string_view content) {
  if (startsWith(content, "\x89PNG")) return decodePng(content);
  if (startsWith(content, "P2") || startsWith(content, "P5")) return parsePgm(content);
  throw InputError("expected a PGM image (P2 or P5) or a PNG image, got a file of another format");
}

}  // namespace

void requireImageSize(std::uint32_t width, std::uint32_t height) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width == 0 || height == 0) throw InputError("expected an image of at least one pixel, got " + size);
  if (std::uint64_t{width} * height > limits::CELLS)
    throw InputError("expected an image of up to " + std::to_string(limits::CELLS) + " pixels, got " + size);
}

MapImage readMapImage(const std::string& file) {
  const std::string content = readFile(file, FileLimits::IMAGE);
  try {
    return parseImage(content);
  } catch (const InputError& error) {
    throw InputError(file + ": " + error.what());
  }
}

}  // namespace crowd
