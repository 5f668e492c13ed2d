// Q-table files: loading and saving the largest table of the thesis with all rows visited.

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>
#include <string>

#include "common/files/files.h"
#include "common/random.h"
#include "learning/q_table_file.h"
#include "measuring.h"
#include "training/training_config.h"

namespace crowd {
namespace {

constexpr std::uint32_t MAX_VISITS = 5000;
constexpr const char* TABLE_FILE = "q_table.txt";  // both in the working directory
constexpr const char* BYTES_FILE = "bytes.txt";

/// The table of thesis set 2 with random values.
TrainedTable makeFullTable() {
  const TrainingConfig config = readTrainingConfig(SOURCE_DIR "/config/learning/thesis_occupancy.yaml");
  QTable table(config.model.state_set->rowCount(), config.model.action_set->size());
  KeyedRandom random(1, KeyedRandom::EXPLORATION, {});
  for (Row row = 0; row < table.rows(); ++row) {
    for (Action action = 0; action < table.actions(); ++action) {
      const double value = random.uniform(-100.0, 100.0);
      table.set(row, action, value, 1 + random.below(MAX_VISITS));
    }
  }
  return {config.model, config.learning.parameters, 0, 1, std::move(table)};
}

void require(bool fine, const char* what) {
  if (!fine) throw std::runtime_error(std::string(what) + " failed");
}

/// The yardstick: plain reading and writing of a file of the same size.
class Bytes {
 public:
  explicit Bytes(const TrainedTable& trained) : bytes_(toText(trained)) { replaceFile(BYTES_FILE, bytes_); }

  void read() {
    const int file = ::open(BYTES_FILE, O_RDONLY | O_CLOEXEC);  // NOLINT(*-vararg)
    std::size_t count = 0;
    for (ssize_t part = 1; part > 0; count += static_cast<std::size_t>(part)) {
      part = ::read(file, bytes_.data() + count, bytes_.size() - count);
      require(part >= 0, "read");
    }
    require(count == bytes_.size() && ::close(file) == 0, "read");
    benchmark::DoNotOptimize(bytes_.data());
  }

  /// Writes to the disk as saving does: to a temporary file, which then replaces the old one.
  void write() const {
    const std::string beside = std::string(BYTES_FILE) + ".new";
    const int file = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);  // NOLINT(*-vararg)
    const bool written = ::write(file, bytes_.data(), bytes_.size()) == static_cast<ssize_t>(bytes_.size());
    require(written && ::fsync(file) == 0 && ::close(file) == 0, "write");
    require(std::rename(beside.c_str(), BYTES_FILE) == 0, "rename");
  }

 private:
  std::string bytes_;
};

void load(benchmark::State& state) {
  const TrainedTable trained = makeFullTable();
  saveQTable(TABLE_FILE, trained);
  Bytes bytes(trained);
  const auto load = [] {
    benchmark::DoNotOptimize(loadQTable(TABLE_FILE));
    return 1;
  };
  takeTurns(state, Clock::ON_WALL, load, [&] { return bytes.read(), 1; });
}

void save(benchmark::State& state) {
  const TrainedTable trained = makeFullTable();
  const Bytes bytes(trained);
  takeTurns(
      state, Clock::ON_WALL, [&] { return saveQTable(TABLE_FILE, trained), 1; }, [&] { return bytes.write(), 1; });
}

}  // namespace

BENCHMARK(load)->Name("q_table_load")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(save)->Name("q_table_save")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace crowd
