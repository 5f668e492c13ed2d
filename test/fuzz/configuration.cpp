// Training configurations.

#include "fuzz/fuzz.h"
#include "support/temporary_folder.h"
#include "training/training_config.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace crowd;
  static const TemporaryFolder folder;
  const std::string name = folder.write("input", fuzz::textOf(data, size));
  return fuzz::feed(size, 1000, [&] { readTrainingConfig(name).model.spec(); });
}
