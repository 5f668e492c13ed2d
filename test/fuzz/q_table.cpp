// Q-table files, with the checksum that their text has.

#include "common/files/checksum.h"
#include "fuzz/fuzz.h"
#include "learning/q_table_file.h"
#include "learning/q_table_format.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace crowd;
  std::string text = fuzz::textOf(data, size);
  Checksum checksum;
  checksum.add(text);
  text.append(q_table_format::Q_TABLE_CHECKSUM_KEY).append(checksum.text()).append("\n");
  return fuzz::feed(size, 1000, [&] {
    const TrainedTable table = parseQTable(text, "table");
    const std::string written = toText(table);
    if (toText(parseQTable(written, "written")) != written) throw std::logic_error("written again, it differs");
  });
}
