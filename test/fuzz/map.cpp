// Maps: the YAML text, a zero byte, and the image, whose name in the text is `image`.

#include <stdlib.h>  // mkdtemp

#include <fstream>

#include "fuzz/fuzz.h"
#include "maps/map_file.h"
#include "maps/map_walls.h"

namespace {

/// A folder in memory for both files; it is used by one process.
std::string makeFolder() {
  std::string folder = "/dev/shm/social_crowd_fuzz_XXXXXX";
  if (::mkdtemp(folder.data()) == nullptr) throw std::runtime_error(folder + " cannot be made");
  return folder;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace crowd;
  static const std::string folder = makeFolder();
  const std::string input = fuzz::textOf(data, size);
  const std::size_t end = std::min(input.find('\0'), size);
  std::ofstream(folder + "/map.yaml") << input.substr(0, end);
  std::ofstream(folder + "/image") << input.substr(std::min(end + 1, size));
  // A PNG image has up to 1032 times the size of its file, four samples of it make a cell and walls.
  return fuzz::feed(size, 20'000, [&] { traceWalls(readMap(folder + "/map.yaml")); });
}
