#include "ros/node/data_folder.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "common/files/files.h"
#include "common/text/quotes.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t MAX_PATH = 1024;  // [bytes]; longer ones cost memory and time before they are refused
constexpr std::size_t MAX_PART = 255;   // [bytes], of file systems
constexpr const char* FOLDER = "social_crowd";

/// Returns the value of an environment variable; an empty text if it is not set.
std::string environment(const char* name) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing changes the environment
  return value == nullptr ? "" : value;
}

void requireName(const std::string& name) {
  if (name.empty()) throw InputError("expected a file name, got an empty text");
  requireShort("name of a file", name, MAX_PATH);
  const auto is_control = [](char letter) { return static_cast<unsigned char>(letter) < ' '; };
  if (std::any_of(name.begin(), name.end(), is_control)) {
    throw InputError("expected a file name without control characters");
  }
  for (const fs::path& part : fs::path(name)) requireShort("part of the name of a file", part.string(), MAX_PART);
}

/// Whether a path without `.` and `..` is the folder or below it.
bool isWithin(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// Whether a part of a path is a link. After all links were followed, these are the ones that lead nowhere yet.
bool hasLink(fs::path path) {
  std::error_code ignored;
  for (; path.has_relative_path(); path = path.parent_path()) {
    if (fs::is_symlink(fs::symlink_status(path, ignored))) return true;
  }
  return false;
}

/// @throws InputError if there is something that is neither a regular file nor a folder, such as a device or a pipe
void requirePlain(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (!fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status)) return;
  throw InputError(path + " is a device, a pipe or a socket, expected a regular file");
}

}  // namespace

DataFolder::DataFolder(const std::string& folder, bool allow_any_path)
    : folder_((fs::absolute(folder) / "").lexically_normal().parent_path().string()),
      allows_any_path_(allow_any_path) {}

std::string DataFolder::defaultFolder() {
  const std::string home = environment("ROS_HOME");
  return (home.empty() ? fs::path(environment("HOME")) / ".ros" / FOLDER : fs::path(home) / FOLDER).string();
}

void DataFolder::prepare() const {
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
}

std::string DataFolder::resolveInside(const std::string& name) const {
  std::error_code problem;
  const fs::path folder = fs::weakly_canonical(folder_, problem);
  const fs::path path = problem ? fs::path() : fs::weakly_canonical(fs::path(folder_) / name, problem);
  if (!problem && isWithin(path, folder) && !hasLink(path)) return path.string();
  throw InputError(inQuotes(name) + " is not in the folder " + folder_ +
                   ", outside of which no service of this node reads or writes files (parameter ~data_folder; "
                   "~allow_any_path: true allows all)");
}

std::string DataFolder::resolve(const std::string& name) const {
  requireName(name);
  std::string path = allows_any_path_ ? (fs::path(folder_) / name).lexically_normal().string() : resolveInside(name);
  requirePlain(path);
  return path;
}

std::string DataFolder::resolveToRead(const std::string& name, const Find& find) const {
  std::string path = resolve(name);
  std::error_code ignored;
  return fs::exists(path, ignored) ? path : find(name, folder_);
}

std::string DataFolder::resolveToWrite(const std::string& name, bool overwrite) const {
  std::string path = resolve(name);
  std::error_code ignored;
  if (!overwrite && fs::is_regular_file(path, ignored)) {
    throw InputError(path + " exists already, and is replaced only with overwrite: true");
  }
  makeFolder(folder_);
  return path;
}

DataFolder readDataFolder(Parameters& parameters) {
  const std::string folder = parameters.text("data_folder", "");
  const bool allow_any_path = parameters.flag("allow_any_path", false);
  return DataFolder(folder.empty() ? DataFolder::defaultFolder() : folder, allow_any_path);
}

}  // namespace crowd
