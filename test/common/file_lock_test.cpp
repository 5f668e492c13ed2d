#include "common/files/file_lock.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "common/files/files.h"
#include "social_crowd/errors.h"
#include "support/file_tests.h"

namespace crowd::file_lock_test {
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

TEST(FileLock, ChangesNothingThatIsNoLock) {
  const TemporaryFolder folder;
  const std::string other = folder.write("other", "1");
  const std::string lock = folder.file("a.lock");
  const auto expect_refused = [&] {
    const std::string message = errorOf<FileError>([&] { FileLock lock(folder.file("a")); });
    EXPECT_EQ(message, lock + ": cannot be written: there is something else of that name, which is no lock");
    EXPECT_EQ(readFile(other), "1");
    EXPECT_EQ(folder.names(), (Names{"a.lock", "other"}));
    std::filesystem::remove(lock);
  };
  std::filesystem::create_symlink("other", lock);
  expect_refused();
  std::filesystem::create_hard_link(other, lock);
  expect_refused();
  makePipe(folder, "a.lock");
  expect_refused();
  folder.write("a.lock", "the lock of another package\n");
  expect_refused();
}

}  // namespace
}  // namespace crowd::file_lock_test
