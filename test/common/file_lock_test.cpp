#include "social_crowd/common/file_lock.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <vector>

#include "social_crowd/common/errors.h"
#include "support/error_of.h"
#include "support/temporary_folder.h"

namespace crowd {
namespace {

using Names = std::vector<std::string>;

TEST(FileLock, KeepsOthersFromTheFile) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a");
  {
    const FileLock lock(file);
    const FileLock other(folder.file("b"));
    const std::string message = errorOf<FileError>([&] { FileLock again(file); });
    EXPECT_EQ(message, file + ": is in use by another process, number " + std::to_string(::getpid()));
  }
  EXPECT_EQ(folder.names(), Names{});
  const FileLock again(file);
}

TEST(FileLock, TakesWhatAProcessThatWasKilledHasLeft) {
  const TemporaryFolder folder;
  folder.write("a.lock", "1");
  { const FileLock lock(folder.file("a")); }
  EXPECT_EQ(folder.names(), Names{});
}

TEST(FileLock, NeedsAFolder) {
  const TemporaryFolder folder;
  const std::string message = errorOf<FileError>([&] { FileLock lock(folder.file("none/a")); });
  EXPECT_TRUE(contains(message, folder.file("none/a") + ": cannot be written")) << message;
}

}  // namespace
}  // namespace crowd
