// The transport between ranks: the only file that uses MPI. Without MPI at build time, processes are alone.

#include "ranks/mpi_communicator.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>

#ifdef SOCIAL_CROWD_MPI
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>
#endif

namespace crowd {
namespace {

/// Whether a launcher of MPI started this process: Open MPI, MPICH and its relatives, Slurm with PMIx.
bool isLaunchedByMpi() {
  constexpr std::array<const char*, 4> VARIABLES = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK", "MPI_LOCALNRANKS"};
  for (const char* const variable : VARIABLES) {
    if (std::getenv(variable) != nullptr) return true;
  }
  return false;
}

#ifndef SOCIAL_CROWD_MPI

/// Whether the launcher says that it started this process only.
bool isLaunchedAlone() {
  constexpr std::array<const char*, 4> SIZES = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_NTASKS", "MPI_LOCALNRANKS"};
  for (const char* const variable : SIZES) {
    const char* const size = std::getenv(variable);
    if (size != nullptr) return std::string(size) == "1";
  }
  return false;
}

#else

constexpr std::size_t LARGEST_PIECE = std::size_t{1} << 30U;  // MPI counts with int [bytes]
constexpr int TAG = 1;

int countOf(std::size_t size) { return static_cast<int>(size); }

/// Ranks of MPI_COMM_WORLD. MPI's own error handler ends all ranks if a call fails.
class MpiCommunicator : public Communicator {
 public:
  MpiCommunicator() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  MpiCommunicator(const MpiCommunicator&) = delete;
  MpiCommunicator& operator=(const MpiCommunicator&) = delete;
  MpiCommunicator(MpiCommunicator&&) = delete;
  MpiCommunicator& operator=(MpiCommunicator&&) = delete;
  ~MpiCommunicator() override { MPI_Finalize(); }

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  [[noreturn]] void abort(const std::string& message) override {
    std::cerr << message << std::endl;
    MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
    std::abort();
  }

 protected:
  void doExchange(const std::vector<Bytes>& out, std::vector<Bytes>& in) override {
    requests_.clear();
    for (int other = 0; other < size_; ++other) {
      if (other != rank_) receive(in[static_cast<std::size_t>(other)], other);
    }
    for (int other = 0; other < size_; ++other) {
      if (other != rank_) send(out[static_cast<std::size_t>(other)], other);
    }
    MPI_Waitall(countOf(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  }

  std::vector<Bytes> doGatherAll(const Bytes& bytes) override {
    const int own = countOf(bytes.size());
    std::vector<int> sizes(static_cast<std::size_t>(size_));
    MPI_Allgather(&own, 1, MPI_INT, sizes.data(), 1, MPI_INT, MPI_COMM_WORLD);
    std::vector<int> starts;
    int total = 0;
    for (const int size : sizes) {
      starts.push_back(total);
      total += size;
    }
    Bytes all(static_cast<std::size_t>(total));
    MPI_Allgatherv(bytes.data(), own, MPI_BYTE, all.data(), sizes.data(), starts.data(), MPI_BYTE, MPI_COMM_WORLD);
    std::vector<Bytes> gathered;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      gathered.emplace_back(all.begin() + starts[i], all.begin() + starts[i] + sizes[i]);
    }
    return gathered;
  }

  void doSum(std::vector<std::uint64_t>& numbers) override {
    MPI_Allreduce(MPI_IN_PLACE, numbers.data(), countOf(numbers.size()), MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  }

 private:
  void receive(Bytes& bytes, int from) {
    for (std::size_t begin = 0; begin < bytes.size(); begin += LARGEST_PIECE) {
      MPI_Irecv(bytes.data() + begin, countOf(std::min(LARGEST_PIECE, bytes.size() - begin)), MPI_BYTE, from, TAG,
                MPI_COMM_WORLD, &requests_.emplace_back());
    }
  }
  void send(const Bytes& bytes, int to) {
    for (std::size_t begin = 0; begin < bytes.size(); begin += LARGEST_PIECE) {
      MPI_Isend(bytes.data() + begin, countOf(std::min(LARGEST_PIECE, bytes.size() - begin)), MPI_BYTE, to, TAG,
                MPI_COMM_WORLD, &requests_.emplace_back());
    }
  }

  int rank_ = 0;
  int size_ = 1;
  std::vector<MPI_Request> requests_;
};

#endif

}  // namespace

#ifdef SOCIAL_CROWD_MPI

bool isBuiltWithMpi() { return true; }

std::unique_ptr<Communicator> joinRanks() {
  if (!isLaunchedByMpi()) return std::make_unique<SingleProcess>();
  return std::make_unique<MpiCommunicator>();
}

#else

bool isBuiltWithMpi() { return false; }

std::unique_ptr<Communicator> joinRanks() {
  if (isLaunchedByMpi() && !isLaunchedAlone()) {
    throw InputError("started by mpirun, but built without MPI: install libopenmpi-dev and build again");
  }
  return std::make_unique<SingleProcess>();
}

#endif

}  // namespace crowd
