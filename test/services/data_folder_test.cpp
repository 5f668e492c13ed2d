#include "ros/node/data_folder.h"

#include <gtest/gtest.h>
#include <stdlib.h>  // setenv
#include <sys/stat.h>

#include <filesystem>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/temporary_folder.h"

namespace crowd::data_folder_test {
namespace {

namespace fs = std::filesystem;

/// A data folder in a folder with other files.
class DataFolderTest : public testing::Test {
 protected:
  DataFolderTest() : home_(fs::canonical(folder_.path()).string()) {
    fs::create_directories(home_ + "/data/sub");
    folder_.write("private.txt", "secret");
    folder_.write("data/mine.txt", "mine");
    folder_.write("data/sub/mine.txt", "mine");
  }

  /// @return whether a name is refused, in all ways in which it can be used
  testing::AssertionResult isOutside(const std::string& name) const {
    for (const std::string& problem : {errorOf<InputError>([&] { data_.resolve(name); }),
                                       errorOf<InputError>([&] { data_.resolveToWrite(name, true); })}) {
      const bool is_told = contains(problem, "is not in the folder " + home_ + "/data, ") &&
                           contains(problem, "~data_folder") && contains(problem, "~allow_any_path");
      if (!is_told) return testing::AssertionFailure() << name << ": " << problem;
    }
    return testing::AssertionSuccess();
  }

  TemporaryFolder folder_;
  std::string home_;
  DataFolder data_{folder_.file("data")};
};

TEST_F(DataFolderTest, NamesAreRelativeToTheFolder) {
  EXPECT_EQ(data_.resolve("mine.txt"), home_ + "/data/mine.txt");
  EXPECT_EQ(data_.resolve("sub/mine.txt"), home_ + "/data/sub/mine.txt");
  EXPECT_EQ(data_.resolve("sub/../new.txt"), home_ + "/data/new.txt");
  EXPECT_EQ(data_.resolve("./none/new.txt"), home_ + "/data/none/new.txt");
  EXPECT_EQ(data_.resolve(folder_.file("data/mine.txt")), home_ + "/data/mine.txt");
}

TEST_F(DataFolderTest, NamesThatLeadOutAreRefused) {
  for (const std::string& name :
       {folder_.file("private.txt"), folder_.file("none.txt"), folder_.path(), folder_.file("data_2/mine.txt"),
        std::string("/etc/passwd"), std::string("/"), std::string(".."), std::string("../private.txt"),
        std::string("sub/../../private.txt"), std::string("none/../../private.txt"), std::string("../data_2/mine.txt"),
        folder_.file("data") + "/../private.txt"}) {
    EXPECT_TRUE(isOutside(name));
  }
}

TEST_F(DataFolderTest, LinksThatLeadOutAreRefused) {
  fs::create_symlink("../private.txt", home_ + "/data/link.txt");
  fs::create_symlink(home_, home_ + "/data/home");
  fs::create_symlink("../none.txt", home_ + "/data/nowhere.txt");
  fs::create_symlink("loop.txt", home_ + "/data/loop.txt");
  for (const char* const name :
       {"link.txt", "home/private.txt", "home/new.txt", "sub/../home/new.txt", "nowhere.txt", "loop.txt"}) {
    EXPECT_TRUE(isOutside(name));
  }
  EXPECT_FALSE(fs::exists(home_ + "/none.txt"));
}

TEST_F(DataFolderTest, LinksWithinTheFolderAreFollowed) {
  fs::create_symlink("sub/mine.txt", home_ + "/data/link.txt");
  EXPECT_EQ(data_.resolve("link.txt"), home_ + "/data/sub/mine.txt");
  fs::create_symlink("data", home_ + "/link");
  EXPECT_EQ(DataFolder(folder_.file("link")).resolve("mine.txt"), home_ + "/data/mine.txt");
  EXPECT_EQ(DataFolder(folder_.file("link/")).resolve("new.txt"), home_ + "/data/new.txt");
}

TEST_F(DataFolderTest, AnyPathIsAllowedIfTheOwnerSaysSo) {
  const DataFolder all(folder_.file("data"), true);
  EXPECT_EQ(all.resolve(folder_.file("private.txt")), folder_.file("private.txt"));
  EXPECT_EQ(all.resolve("../private.txt"), folder_.file("private.txt"));
  EXPECT_EQ(all.resolve("mine.txt"), folder_.file("data/mine.txt"));
  EXPECT_TRUE(contains(errorOf<InputError>([&] { all.resolveToWrite("../private.txt", false); }), "exists already"));
  EXPECT_TRUE(contains(errorOf<InputError>([&] { all.resolve("/dev/zero"); }), "expected a regular file"));
}

TEST_F(DataFolderTest, InvalidNamesAreRefused) {
  EXPECT_TRUE(contains(errorOf<InputError>([&] { data_.resolve(""); }), "got an empty text"));
  EXPECT_TRUE(contains(errorOf<InputError>([&] { data_.resolve(std::string(300, 'a')); }), "at most 255 characters"));
  EXPECT_TRUE(contains(errorOf<InputError>([&] { data_.resolve("a\nb"); }), "control characters"));
  EXPECT_TRUE(contains(errorOf<InputError>([&] { data_.resolve(std::string("mine.txt\0b", 10)); }), "control"));
  std::string deep;
  while (deep.size() < 100'000'000) deep += "a/";  // as a path, it would take gigabytes
  const std::string problem = errorOf<InputError>([&] { data_.resolve(deep); });
  EXPECT_EQ(problem, "name of a file: expected at most 1024 characters, got 100000000");
}

TEST_F(DataFolderTest, PipesAndDevicesAreRefused) {
  ASSERT_EQ(::mkfifo((home_ + "/data/pipe").c_str(), 0600), 0);
  for (const std::string& problem : {errorOf<InputError>([&] { data_.resolve("pipe"); }),
                                     errorOf<InputError>([&] { data_.resolveToWrite("pipe", true); })}) {
    EXPECT_TRUE(contains(problem, "pipe is a device, a pipe or a socket, expected a regular file")) << problem;
  }
}

TEST_F(DataFolderTest, NothingIsOverwrittenUnlessItIsWanted) {
  const std::string file = home_ + "/data/mine.txt";
  EXPECT_EQ(errorOf<InputError>([&] { data_.resolveToWrite("mine.txt", false); }),
            file + " exists already, and is replaced only with overwrite: true");
  EXPECT_EQ(data_.resolveToWrite("mine.txt", true), file);
  EXPECT_EQ(data_.resolveToWrite("new.txt", false), home_ + "/data/new.txt");
}

TEST_F(DataFolderTest, IsMadeWhenItIsWrittenTo) {
  const DataFolder data(folder_.file("a/b"));
  const auto find_nothing = [](const std::string& name, const std::string& folder) { return folder + " " + name; };
  EXPECT_EQ(data.resolveToRead("new.txt", find_nothing), folder_.file("a/b") + " new.txt");
  EXPECT_NE(errorOf<InputError>([&] { data.resolveToWrite("../../private.txt", true); }), "no error");
  EXPECT_FALSE(fs::exists(home_ + "/a"));
  EXPECT_EQ(data.resolveToWrite("new.txt", false), home_ + "/a/b/new.txt");
  EXPECT_TRUE(fs::is_directory(home_ + "/a/b"));
}

TEST_F(DataFolderTest, ToReadItsFilesTakePrecedence) {
  const auto find = [](const std::string& /*name*/, const std::string& /*folder*/) { return std::string("shipped"); };
  EXPECT_EQ(data_.resolveToRead("mine.txt", find), home_ + "/data/mine.txt");
  EXPECT_EQ(data_.resolveToRead("other.txt", find), "shipped");
  EXPECT_NE(errorOf<InputError>([&] { data_.resolveToRead("../private.txt", find); }), "no error");
}

TEST_F(DataFolderTest, IsInTheFolderOfRosByDefault) {
  ASSERT_EQ(::setenv("ROS_HOME", home_.c_str(), 1), 0);
  EXPECT_EQ(DataFolder().folder(), home_ + "/social_crowd");
  ASSERT_EQ(::unsetenv("ROS_HOME"), 0);
  ASSERT_EQ(::setenv("HOME", home_.c_str(), 1), 0);
  EXPECT_EQ(DataFolder::defaultFolder(), home_ + "/.ros/social_crowd");
}

}  // namespace
}  // namespace crowd::data_folder_test
