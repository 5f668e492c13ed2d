// Checkpoints of one training, with the checksum that their text has.

#include "training/checkpoint.h"

#include "common/files/checksum.h"
#include "fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace crowd;
  static const Model model = parseModel(
      "state_set: {type: nearest_obstacle}\naction_set: {type: kings_moves}\n"
      "reward: {goal: cosine_cubed, obstacle_cost: 80}\n");
  std::string text = "social_crowd checkpoint 1\nidentity\n---\n" + fuzz::textOf(data, size);
  Checksum checksum;
  checksum.add(text);
  text += "checksum: " + checksum.text() + "\n";
  return fuzz::feed(size, 1000, [&] {
    const std::string written = toText(parseCheckpoint(text, "checkpoint", "identity\n", model));
    if (toText(parseCheckpoint(written, "written", "identity\n", model)) != written)
      throw std::logic_error("written again, it differs");
  });
}
