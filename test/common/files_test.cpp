#include "social_crowd/common/files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "social_crowd/common/errors.h"
#include "support/error_of.h"
#include "support/temporary_folder.h"

namespace crowd {
namespace {

using Names = std::vector<std::string>;

/// During its lifetime, no file of this process can grow beyond a number of bytes; simulates a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

void expectFileError(const std::string& message, const std::string& file, int reason) {
  EXPECT_TRUE(contains(message, file)) << message;
  EXPECT_TRUE(contains(message, std::strerror(reason))) << message;
}

TEST(ReadFile, ReturnsEveryByte) {
  const TemporaryFolder folder;
  const std::string content("a\r\nb\0c\n\n\xFF", 9);
  EXPECT_EQ(readFile(folder.write("file", content)), content);
  EXPECT_EQ(readFile(folder.write("empty", "")), "");
}

TEST(ReadFile, ReadsLargeFiles) {
  const TemporaryFolder folder;
  std::string content;
  while (content.size() < 3000000) content += std::to_string(content.size()) + "\n";
  EXPECT_EQ(readFile(folder.write("file", content)), content);
}

TEST(ReadFile, NamesAMissingFile) {
  const TemporaryFolder folder;
  expectFileError(errorOf<FileError>([&] { readFile(folder.file("none")); }), folder.file("none"), ENOENT);
}

TEST(ReadFile, RefusesAFolder) {
  const TemporaryFolder folder;
  const std::string message = errorOf<FileError>([&] { readFile(folder.path()); });
  EXPECT_TRUE(contains(message, folder.path() + ": is a folder")) << message;
}

TEST(ReadFile, ReportsAReadError) {
  // Linux lets a process open its own memory, but address 0 holds nothing: reading fails with EIO.
  const std::string file = "/proc/self/mem";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "needs Linux";
  EXPECT_TRUE(contains(errorOf<FileError>([&] { readFile(file); }), file));
}

TEST(ReplaceFile, CreatesAndReplacesAFile) {
  const TemporaryFolder folder;
  const std::string content("a\r\nb\0c\n\n\xFF", 9);
  replaceFile(folder.file("file"), content);
  EXPECT_EQ(readFile(folder.file("file")), content);
  replaceFile(folder.file("file"), "short");
  EXPECT_EQ(readFile(folder.file("file")), "short");
  replaceFile(folder.file("file"), "");
  EXPECT_EQ(readFile(folder.file("file")), "");
  EXPECT_EQ(folder.names(), Names{"file"});
}

TEST(ReplaceFile, WritesLargeFiles) {
  const TemporaryFolder folder;
  const std::string content(5000000, 'x');
  replaceFile(folder.file("file"), content);
  EXPECT_EQ(readFile(folder.file("file")), content);
}

TEST(ReplaceFile, NamesAMissingFolder) {
  const TemporaryFolder folder;
  const std::string file = folder.file("none/file");
  const std::string message =
      file + ": cannot be written: " + std::strerror(ENOENT) + ": there is no folder " + folder.file("none");
  EXPECT_EQ(errorOf<FileError>([&] { replaceFile(file, "new"); }), message);
  EXPECT_EQ(errorOf<FileError>([&] { requireReplaceable(file); }), message);
  EXPECT_EQ(errorOf<FileError>([&] { GrowingFile(file, "new"); }), message);
  EXPECT_EQ(folder.names(), Names{});
}

TEST(RequireReplaceable, WritesNothing) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "old");
  requireReplaceable(folder.file("new"));
  requireReplaceable(file);
  requireReplaceable("in_the_working_directory");
  EXPECT_EQ(readFile(file), "old");
  EXPECT_EQ(folder.names(), Names{"file"});
}

TEST(RequireReplaceable, RefusesAFolderAndAPathThroughAFile) {
  const TemporaryFolder folder;
  expectFileError(errorOf<FileError>([&] { requireReplaceable(folder.path()); }), folder.path(), EISDIR);
  const std::string below = folder.write("file", "old") + "/below/file";
  expectFileError(errorOf<FileError>([&] { requireReplaceable(below); }), below, ENOTDIR);
}

TEST(ReplaceFile, RefusesAPathThroughAFile) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "old") + "/below";
  const std::string message = errorOf<FileError>([&] { replaceFile(file, "new"); });
  EXPECT_EQ(message, file + ": cannot be written: " + std::strerror(ENOTDIR));  // does not name the temporary file
  EXPECT_EQ(readFile(folder.file("file")), "old");
  EXPECT_EQ(folder.names(), Names{"file"});
}

TEST(ReplaceFile, KeepsAFolderOfThatName) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("taken"));
  folder.write("taken/file", "old");
  const std::string message = errorOf<FileError>([&] { replaceFile(folder.file("taken"), "new"); });
  EXPECT_TRUE(contains(message, folder.file("taken"))) << message;
  EXPECT_EQ(readFile(folder.file("taken/file")), "old");
  EXPECT_EQ(folder.names(), Names{"taken"});
}

TEST(ReplaceFile, KeepsTheOldFileWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  std::string message;
  {
    const FileSizeLimit limit(1000);
    message = errorOf<FileError>([&] { replaceFile(folder.file("file"), std::string(5000, 'x')); });
  }
  expectFileError(message, folder.file("file"), EFBIG);
  EXPECT_EQ(readFile(folder.file("file")), "old");
  EXPECT_EQ(folder.names(), Names{"file"});
}

TEST(ReplaceFile, KeepsTheOldFileInAFolderWithoutWritePermission) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TemporaryFolder folder;
  folder.write("file", "old");
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  const std::string message = errorOf<FileError>([&] { replaceFile(folder.file("file"), "new"); });
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  expectFileError(message, folder.file("file"), EACCES);
  EXPECT_EQ(readFile(folder.file("file")), "old");
  EXPECT_EQ(folder.names(), Names{"file"});
}

TEST(GrowingFile, GoesOnAfterItsFirstBytes) {
  const TemporaryFolder folder;
  const std::string file = folder.file("file");
  {
    GrowingFile grows(file, "first\n");
    grows.append("second\n");
    grows.flushToDisk();
    EXPECT_EQ(grows.size(), 13U);
    grows.append("third, cut sh");
  }
  GrowingFile grows(file, 13);
  EXPECT_EQ(readFile(file), "first\nsecond\n");
  grows.append("third\n");
  EXPECT_EQ(grows.size(), 19U);
  EXPECT_EQ(readFile(file), "first\nsecond\nthird\n");
}

TEST(GrowingFile, CannotGoOnInAMissingFile) {
  const TemporaryFolder folder;
  expectFileError(errorOf<FileError>([&] { GrowingFile(folder.file("none"), 5); }), folder.file("none"), ENOENT);
  EXPECT_EQ(folder.names(), Names{});
}

TEST(RemoveTemporaries, KeepsOtherFiles) {
  const TemporaryFolder folder;
  const std::string ended = "file.tmp" + std::to_string(INT32_MAX);  // no process has this number
  const std::string running = "file.tmp" + std::to_string(::getpid());
  for (const std::string& name : {std::string("file"), ended, running, "other" + ended, ended + "x"}) {
    folder.write(name, "old");
  }
  removeTemporaries(folder.file("file"));
  Names kept = {"file", running, ended + "x", "other" + ended};
  std::sort(kept.begin(), kept.end());
  EXPECT_EQ(folder.names(), kept);
}

TEST(MakeFolder, CreatesParentFolders) {
  const TemporaryFolder folder;
  makeFolder(folder.file("a/b/c"));
  EXPECT_TRUE(std::filesystem::is_directory(folder.file("a/b/c")));
  folder.write("a/file", "old");
  makeFolder(folder.file("a"));  // exists already: nothing changes
  EXPECT_EQ(readFile(folder.file("a/file")), "old");
}

TEST(MakeFolder, RefusesThePathOfAFile) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  for (const std::string& place : {folder.file("file"), folder.file("file/below")}) {
    const std::string message = errorOf<FileError>([&] { makeFolder(place); });
    EXPECT_TRUE(contains(message, place)) << message;
  }
  EXPECT_EQ(readFile(folder.file("file")), "old");
}

TEST(StemOf, RemovesFolderAndExtension) {
  EXPECT_EQ(stemOf("a/b/circle6.yaml"), "circle6");
  EXPECT_EQ(stemOf("circle6.yaml"), "circle6");
  EXPECT_EQ(stemOf("/a.b/circle6"), "circle6");
  EXPECT_EQ(stemOf("circle6.v2.yaml"), "circle6.v2");
}

}  // namespace
}  // namespace crowd
