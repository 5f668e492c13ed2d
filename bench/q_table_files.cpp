// Q-table files: loading and saving the largest table of the thesis, every row of it visited.

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>
#include <string>

#include "social_crowd/common/files.h"
#include "social_crowd/common/random.h"
#include "social_crowd/learning/q_table_file.h"
#include "social_crowd/simulation/recipe.h"

namespace crowd {
namespace {

constexpr std::uint32_t MOST_VISITS = 5000;
constexpr const char* TABLE_FILE = "q_table.txt";  // both in the folder that the benchmarks are started in
constexpr const char* BYTES_FILE = "bytes.txt";

/// The table of thesis set 2 with values of all sizes.
TrainedTable makeFullTable() {
  const Recipe recipe = readRecipe(SOURCE_DIR "/config/learning/thesis_occupancy.yaml");
  QTable table(recipe.model.state_set->rowCount(), recipe.model.action_set->size());
  KeyedRandom random(1, KeyedRandom::EXPLORATION, {});
  for (Row row = 0; row < table.rows(); ++row) {
    for (Action action = 0; action < table.actions(); ++action) {
      const double value = random.uniform(-100.0, 100.0);
      table.set(row, action, value, 1 + random.below(MOST_VISITS));
    }
  }
  return {recipe.model, recipe.learning.parameters, 0, 1, std::move(table)};
}

void require(bool fine, const char* what) {
  if (!fine) throw std::runtime_error(std::string(what) + " failed");
}

void load(benchmark::State& state) {
  saveQTable(TABLE_FILE, makeFullTable());
  for (auto _ : state) benchmark::DoNotOptimize(loadQTable(TABLE_FILE));
}

void save(benchmark::State& state) {
  const TrainedTable trained = makeFullTable();
  for (auto _ : state) saveQTable(TABLE_FILE, trained);
}

/// Reads as many bytes, and nothing more.
void readBytes(benchmark::State& state) {
  std::string bytes = toText(makeFullTable());
  replaceFile(BYTES_FILE, bytes);
  for (auto _ : state) {
    const int file = ::open(BYTES_FILE, O_RDONLY | O_CLOEXEC);  // NOLINT(*-vararg)
    std::size_t count = 0;
    for (ssize_t part = 1; part > 0; count += static_cast<std::size_t>(part)) {
      part = ::read(file, bytes.data() + count, bytes.size() - count);
      require(part >= 0, "read");
    }
    require(count == bytes.size() && ::close(file) == 0, "read");
    benchmark::DoNotOptimize(bytes.data());
  }
}

/// Writes as many bytes and brings them to the disk as saving does: beside the old file, which they then replace.
void writeBytes(benchmark::State& state) {
  const std::string bytes = toText(makeFullTable());
  const std::string beside = std::string(BYTES_FILE) + ".new";
  for (auto _ : state) {
    const int file = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);  // NOLINT(*-vararg)
    const bool written = ::write(file, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
    require(written && ::fsync(file) == 0 && ::close(file) == 0, "write");
    require(std::rename(beside.c_str(), BYTES_FILE) == 0, "rename");
  }
}

}  // namespace

BENCHMARK(load)->Name("q_table_load")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(readBytes)->Name("q_table_load/yardstick")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(save)->Name("q_table_save")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(writeBytes)->Name("q_table_save/yardstick")->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace crowd
