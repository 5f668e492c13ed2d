// Recordings of people: CSV, the text of JuPedSim, obsmat.txt.

#include "fuzz/fuzz.h"
#include "scenario/reading/recording_file.h"
#include "support/temporary_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace crowd;
  static const TemporaryFolder folder;
  const std::string name = folder.write("input", fuzz::textOf(data, size));
  return fuzz::feed(size, 1000, [&] { readRecording(name, std::nullopt); });
}
