#include "common/stop_request.h"

#include <gtest/gtest.h>

namespace crowd::stop_request_test {
namespace {

TEST(StopRequest, IsNeverMadeWithoutAFunction) {
  EXPECT_FALSE(StopRequest().isMade());
  EXPECT_NO_THROW(StopRequest().throwIfMade());
}

TEST(StopRequest, CopiesAskTheSameFunction) {
  bool is_made = false;
  const StopRequest request([&] { return is_made; });
  const StopRequest copy = request;
  EXPECT_NO_THROW(copy.throwIfMade());
  is_made = true;
  EXPECT_TRUE(request.isMade());
  EXPECT_THROW(copy.throwIfMade(), Stopped);
}

}  // namespace
}  // namespace crowd::stop_request_test
