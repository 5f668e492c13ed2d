#include "training/communicator.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/error_of.h"
#include "support/thread_ranks.h"

namespace crowd::communicator_test {
namespace {

Communicator::Bytes bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

TEST(Communicator, ExchangesMessagesOfAnySize) {
  ThreadRanks(3).run([](Communicator& communicator) {
    const int rank = communicator.rank();
    std::vector<Communicator::Bytes> out;
    for (int to = 0; to < 3; ++to) out.push_back(bytesOf(std::string(rank, 'a') + std::to_string(to)));
    out[(rank + 1) % 3].clear();
    std::vector<Communicator::Bytes> in(7, bytesOf("old"));
    communicator.exchangeAnySize(out, in);
    ASSERT_EQ(in.size(), 3U);
    for (int from = 0; from < 3; ++from) {
      const bool is_sent = from != rank && (from + 1) % 3 != rank;
      EXPECT_EQ(in[from], bytesOf(is_sent ? std::string(from, 'a') + std::to_string(rank) : "")) << rank << from;
    }
  });
}

TEST(Communicator, GathersAndSums) {
  ThreadRanks(3).run([](Communicator& communicator) {
    const auto rank = static_cast<std::uint64_t>(communicator.rank());
    const std::vector<Communicator::Bytes> all = communicator.gatherAll(bytesOf(std::string(rank, 'x')));
    EXPECT_EQ(all, (std::vector<Communicator::Bytes>{bytesOf(""), bytesOf("x"), bytesOf("xx")}));
    EXPECT_EQ(communicator.sentBytes(), 2 * rank) << "to both others";
    std::vector<std::uint64_t> numbers = {rank, 10};
    communicator.sum(numbers);
    EXPECT_EQ(numbers, (std::vector<std::uint64_t>{3, 30}));
  });
}

TEST(Communicator, BroadcastsTheBytesOfTheFirstRank) {
  for (const int ranks : {1, 3}) {
    ThreadRanks(ranks).run([](Communicator& communicator) {
      Communicator::Bytes bytes = bytesOf(communicator.rank() == 0 ? "first" : "another one");
      communicator.broadcast(bytes);
      EXPECT_EQ(bytes, bytesOf("first"));
    });
  }
  Communicator::Bytes bytes = bytesOf("alone");
  SingleProcess::instance().broadcast(bytes);
  EXPECT_EQ(bytes, bytesOf("alone"));
}

TEST(Communicator, SharesAnErrorOfOneRank) {
  ThreadRanks(3).run([](Communicator& communicator) {
    const auto fail_on_1 = [&] {
      if (communicator.rank() == 1) throw InputError("no table");
    };
    const auto fail_on_all = [] { throw InputError("no scenario"); };
    doOnAllRanks(communicator, [] {});
    EXPECT_EQ(errorOf<SharedError>([&] { doOnAllRanks(communicator, fail_on_1); }), "rank 1: no table");
    EXPECT_EQ(errorOf<SharedError>([&] { doOnAllRanks(communicator, fail_on_all); }), "no scenario");
  });
}

TEST(Communicator, NamesTheRankThatDiffers) {
  ThreadRanks(3).run([](Communicator& communicator) {
    const std::string seed = communicator.rank() == 2 ? "7" : "5";
    requireSameOnAllRanks(communicator, {{"version", "1"}});
    EXPECT_EQ(errorOf<SharedError>([&] {
                requireSameOnAllRanks(communicator, {{"version", "1"}, {"seed", seed}});
              }),
              "rank 2 differs from rank 0 in the seed: '7' there, '5' on rank 0; all ranks need the same program, "
              "arguments and files");
  });
}

TEST(Communicator, NamesTheFirstLineThatDiffers) {
  ThreadRanks(2).run([](Communicator& communicator) {
    const auto error = [&](const std::string& here, const std::string& there) {
      const std::string text = communicator.rank() == 0 ? here : there;
      return errorOf<SharedError>([&] { requireSameOnAllRanks(communicator, {{"training", text}}); });
    };
    EXPECT_TRUE(
        contains(error("a: 1\nb: 2\nc: 3\n", "a: 1\nb: 7\nc: 8\n"), "training: 'b: 7' there, 'b: 2' on rank 0"));
    EXPECT_TRUE(contains(error("a: 1\nb: 2\n", "a: 1\n"), "training: '' there, 'b: 2' on rank 0"));
    EXPECT_EQ(error("a: 1\nb: 2\n", "a: 1\nb: 2\n"), "no error");
  });
}

}  // namespace
}  // namespace crowd::communicator_test
