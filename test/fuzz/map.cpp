// Maps: the YAML text, a zero byte, and the image, whose name in the text is `image`.

#include "fuzz/fuzz.h"
#include "maps/map_file.h"
#include "maps/map_walls.h"
#include "support/png_texts.h"
#include "support/temporary_folder.h"

namespace {

/// Corrects the checksums of a PNG image, which nearly all changes of it would break.
std::string withChecksums(std::string image) {
  constexpr std::size_t FRAME = 12;  // [bytes] of length, type and checksum of a chunk
  for (std::size_t at = 8; image.size() >= at + FRAME;) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = 256 * length + static_cast<unsigned char>(image[at + i]);
    if (length > image.size() - at - FRAME) break;
    image.replace(at + 8 + length, 4, crowd::png::bigEndian(crowd::png::crcOf(image.substr(at + 4, 4 + length))));
    at += FRAME + length;
  }
  return image;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace crowd;
  static const TemporaryFolder folder;
  const std::string input = fuzz::textOf(data, size);
  const std::size_t end = std::min(input.find('\0'), size);
  const std::string name = folder.write("map.yaml", input.substr(0, end));
  const std::string image = input.substr(std::min(end + 1, size));
  folder.write("image", image[0] == 'P' ? image : withChecksums(image));
  // A PNG image has up to 1032 times the size of its file, four samples of it make a cell and walls.
  return fuzz::feed(size, 20'000, [&] { traceWalls(readMap(name)); });
}
