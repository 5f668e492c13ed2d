#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "training/communicator.h"

namespace crowd {

/// Ranks that are threads of this process, so that tests need no MPI.
class ThreadRanks {
 public:
  using Bytes = Communicator::Bytes;

  explicit ThreadRanks(int count) : count_(count), bytes_(count), messages_(count), numbers_(count) {}

  /// Runs work(communicator) on each rank. Rethrows the exception of the lowest rank that threw; if only some of them
  /// throw, the others throw in their next call.
  void run(const std::function<void(Communicator&)>& work) {
    std::vector<std::exception_ptr> problems(count_);
    std::vector<std::thread> threads;
    for (int rank = 0; rank < count_; ++rank) {
      threads.emplace_back([&, rank] {
        try {
          Rank communicator(*this, rank);
          work(communicator);
        } catch (...) {
          problems[rank] = std::current_exception();
          fail();
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    for (const std::exception_ptr& problem : problems) {
      if (problem != nullptr) std::rethrow_exception(problem);
    }
  }

 private:
  class Rank : public Communicator {
   public:
    Rank(ThreadRanks& all, int rank) : all_(all), rank_(rank) {}
    int rank() const override { return rank_; }
    int size() const override { return all_.count_; }
    [[noreturn]] void abort(const std::string& message) override { throw Error(message); }

   protected:
    void doExchange(const std::vector<Bytes>& out, std::vector<Bytes>& in) override {
      all_.messages_[rank_] = &out;
      all_.meet();
      for (int from = 0; from < size(); ++from) {
        if (from == rank_) continue;
        const Bytes& message = (*all_.messages_[from])[rank_];
        if (message.size() != in[from].size()) throw Error("a message has another size than was expected");
        in[from] = message;
      }
      all_.meet();
    }
    std::vector<Bytes> doGatherAll(const Bytes& bytes) override {
      all_.bytes_[rank_] = bytes;
      all_.meet();
      std::vector<Bytes> gathered = all_.bytes_;
      all_.meet();
      return gathered;
    }
    void doSum(std::vector<std::uint64_t>& numbers) override {
      all_.numbers_[rank_] = numbers;
      all_.meet();
      for (int from = 0; from < size(); ++from) {
        for (std::size_t i = 0; from != rank_ && i < numbers.size(); ++i) numbers[i] += all_.numbers_[from].at(i);
      }
      all_.meet();
    }

   private:
    ThreadRanks& all_;
    int rank_;
  };

  /// Waits until all ranks are here.
  void meet() {
    std::unique_lock<std::mutex> lock(mutex_);
    const std::uint64_t round = round_;
    if (++waiting_ == count_) {
      waiting_ = 0;
      ++round_;
      changed_.notify_all();
    } else {
      changed_.wait(lock, [&] { return round_ != round || has_failed_; });
    }
    if (has_failed_) throw Error("another rank has failed");
  }

  void fail() {
    const std::lock_guard<std::mutex> lock(mutex_);
    has_failed_ = true;
    changed_.notify_all();
  }

  int count_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int waiting_ = 0;
  std::uint64_t round_ = 0;
  bool has_failed_ = false;
  std::vector<Bytes> bytes_;
  std::vector<const std::vector<Bytes>*> messages_;
  std::vector<std::vector<std::uint64_t>> numbers_;
};

}  // namespace crowd
