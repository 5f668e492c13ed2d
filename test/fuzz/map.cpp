// Maps: the YAML text, a zero byte, and the image, whose name in the text is `image`.

#include "fuzz/fuzz.h"
#include "maps/map_file.h"
#include "maps/map_walls.h"
#include "support/temporary_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace crowd;
  static const TemporaryFolder folder;
  const std::string input = fuzz::textOf(data, size);
  const std::size_t end = std::min(input.find('\0'), size);
  const std::string name = folder.write("map.yaml", input.substr(0, end));
  folder.write("image", input.substr(std::min(end + 1, size)));
  // A PNG image has up to 1032 times the size of its file, four samples of it make a cell and walls.
  return fuzz::feed(size, 20'000, [&] { traceWalls(readMap(name)); });
}
