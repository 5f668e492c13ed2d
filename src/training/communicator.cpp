#include "training/communicator.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <utility>

#include "common/error_message.h"
#include "simulation/byte_archive.h"

namespace crowd {
namespace {

Communicator::Bytes bytesOf(const std::string& text) { return {text.begin(), text.end()}; }
std::string textOf(const Communicator::Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

/// Returns the first lines of two different texts that differ.
std::pair<std::string, std::string> firstDifference(const std::string& one, const std::string& other) {
  std::istringstream ones(one);
  std::istringstream others(other);
  std::pair<std::string, std::string> lines;
  do {
    lines = {};
    std::getline(ones, lines.first);
    std::getline(others, lines.second);
  } while (lines.first == lines.second && (ones || others));
  return lines;
}

}  // namespace

void Communicator::exchange(const std::vector<Bytes>& out, std::vector<Bytes>& in) {
  for (const Bytes& bytes : out) sent_ += bytes.size();
  doExchange(out, in);
}

void Communicator::exchangeAnySize(const std::vector<Bytes>& out, std::vector<Bytes>& in) {
  Bytes sizes;
  ByteWriter write(sizes);
  for (const Bytes& bytes : out) write(static_cast<std::uint64_t>(bytes.size()));
  const std::vector<Bytes> all = gatherAll(sizes);
  in.resize(out.size());
  for (std::size_t from = 0; from < all.size(); ++from) {
    ByteReader read(all[from]);
    std::uint64_t size = 0;
    for (int to = 0; to <= rank(); ++to) read(size);
    in[from].resize(size);
  }
  in[static_cast<std::size_t>(rank())].clear();
  exchange(out, in);
}

std::vector<Communicator::Bytes> Communicator::gatherAll(const Bytes& bytes) {
  sent_ += bytes.size() * static_cast<std::size_t>(size() - 1);
  return doGatherAll(bytes);
}

void Communicator::broadcast(Bytes& bytes) {
  std::vector<Bytes> out(static_cast<std::size_t>(size()));
  if (rank() == 0) std::fill(out.begin() + 1, out.end(), bytes);
  std::vector<Bytes> in;
  exchangeAnySize(out, in);
  if (rank() != 0) bytes = std::move(in.front());
}

void Communicator::sum(std::vector<std::uint64_t>& numbers) {
  if (size() > 1) sent_ += numbers.size() * sizeof(std::uint64_t);
  doSum(numbers);
}

SingleProcess& SingleProcess::instance() {
  static SingleProcess process;
  return process;
}

void SingleProcess::abort(const std::string& message) {
  std::cerr << message << std::endl;
  std::exit(EXIT_FAILURE);
}

void doOnAllRanks(Communicator& communicator, const std::function<void()>& work) {
  std::string problem;
  try {
    work();
  } catch (const std::exception& error) {
    problem = messageOf(error);
    if (problem.empty()) problem = "unknown error";
  }
  const std::vector<Communicator::Bytes> problems = communicator.gatherAll(bytesOf(problem));
  bool are_same = true;
  for (const Communicator::Bytes& other : problems) are_same = are_same && other == problems.front();
  for (std::size_t rank = 0; rank < problems.size(); ++rank) {
    const std::string text = textOf(problems[rank]);
    if (!text.empty()) throw SharedError((are_same ? "" : "rank " + std::to_string(rank) + ": ") + text);
  }
}

RankSpread spreadOf(Communicator& communicator, double number) {
  Communicator::Bytes bytes;
  ByteWriter write(bytes);
  write(number);
  RankSpread spread;
  for (const Communicator::Bytes& other : communicator.gatherAll(bytes)) {
    ByteReader read(other);
    read(number);
    spread.largest = std::max(spread.largest, number);
    spread.mean += number / communicator.size();
  }
  return spread;
}

void requireSameOnAllRanks(Communicator& communicator, const std::vector<SharedFact>& facts) {
  for (const SharedFact& fact : facts) {
    const std::vector<Communicator::Bytes> values = communicator.gatherAll(bytesOf(fact.value));
    for (std::size_t rank = 1; rank < values.size(); ++rank) {
      if (values[rank] == values.front()) continue;
      const auto [there, here] = firstDifference(textOf(values[rank]), textOf(values.front()));
      std::string text = "rank " + std::to_string(rank) + " differs from rank 0 in the " + fact.what;
      text.append(": '").append(there).append("' there, '").append(here);
      throw SharedError(text.append("' on rank 0; all ranks need the same program, arguments and files"));
    }
  }
}

}  // namespace crowd
