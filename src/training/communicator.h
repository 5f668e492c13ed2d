#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "social_crowd/errors.h"

namespace crowd {

/// @brief Processes ("ranks") that compute together, and the messages between them.
///
/// All functions but abort() are collective: all ranks call them in the same order, and each call returns when this
/// rank has what it is to receive. One thread of each rank uses it.
class Communicator {
 public:
  using Bytes = std::vector<char>;

  Communicator() = default;
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;
  Communicator(Communicator&&) = delete;
  Communicator& operator=(Communicator&&) = delete;
  virtual ~Communicator() = default;

  /// @brief Number of this rank, 0 to size() - 1.
  virtual int rank() const = 0;
  virtual int size() const = 0;

  /// @brief Sends out[r] to each rank r, and receives in[r] from it, whose size must be that of the message. Empty ones
  /// are not sent. Both have one element for each rank; those of this rank are not used.
  void exchange(const std::vector<Bytes>& out, std::vector<Bytes>& in);
  /// @brief The same for messages of sizes that the receiver does not know; `in` is overwritten.
  void exchangeAnySize(const std::vector<Bytes>& out, std::vector<Bytes>& in);
  /// @brief Returns the bytes of each rank, in the order of the ranks. For small messages: below 1 GB in total.
  std::vector<Bytes> gatherAll(const Bytes& bytes);
  /// @brief Replaces the bytes by those of rank 0.
  void broadcast(Bytes& bytes);
  /// @brief Replaces each number by its sum over all ranks.
  void sum(std::vector<std::uint64_t>& numbers);

  /// @brief Prints a message and ends all ranks with an error.
  [[noreturn]] virtual void abort(const std::string& message) = 0;

  /// @brief Number of bytes that this rank has sent.
  std::uint64_t sentBytes() const { return sent_; }

 protected:
  virtual void doExchange(const std::vector<Bytes>& out, std::vector<Bytes>& in) = 0;
  virtual std::vector<Bytes> doGatherAll(const Bytes& bytes) = 0;
  virtual void doSum(std::vector<std::uint64_t>& numbers) = 0;

 private:
  std::uint64_t sent_ = 0;
};

/// @brief A process alone.
class SingleProcess : public Communicator {
 public:
  /// @brief One for everything that runs alone. rank() and size() may be called by any thread.
  static SingleProcess& instance();
  int rank() const override { return 0; }
  int size() const override { return 1; }
  [[noreturn]] void abort(const std::string& message) override;

 protected:
  void doExchange(const std::vector<Bytes>& /*out*/, std::vector<Bytes>& /*in*/) override {}
  std::vector<Bytes> doGatherAll(const Bytes& bytes) override { return {bytes}; }
  void doSum(std::vector<std::uint64_t>& /*numbers*/) override {}
};

/// @brief An error that all ranks know of, so that all of them end; rank 0 reports it.
class SharedError : public Error {
 public:
  using Error::Error;
};

/// @brief Does a part of the work on each rank. If it throws on any of them, all throw: SharedError with the message
/// of the first such rank, and its number unless all ranks have the same message.
void doOnAllRanks(Communicator& communicator, const std::function<void()>& work);

/// @brief A number of all ranks; the same on all of them.
struct RankSpread {
  double largest = 0.0;  ///< of non-negative numbers
  double mean = 0.0;

  /// @brief largest / mean; 1 if all numbers are 0.
  double imbalance() const { return mean > 0.0 ? largest / mean : 1.0; }
};

/// @brief Returns the largest and the mean of the ranks' numbers. Collective.
RankSpread spreadOf(Communicator& communicator, double number);

/// @brief Something that must be the same on all ranks.
struct SharedFact {
  std::string what;   ///< such as "Q-table 'a.txt'"
  std::string value;  ///< text or checksum
};

/// @brief Compares the facts of all ranks; each must give them in the same order.
/// @throws SharedError that names the first rank that differs from rank 0, and in what; of values of several lines, the
/// first line that differs
void requireSameOnAllRanks(Communicator& communicator, const std::vector<SharedFact>& facts);

}  // namespace crowd
