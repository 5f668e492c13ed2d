#pragma once

#include <functional>
#include <string>

#include "ros/node/parameters.h"

namespace crowd {

/// @brief The files that requests to the services of a node may name. They are in one folder, `~data_folder`, unless
/// the node allows any path: whoever reaches a node must not reach every file of its user.
///
/// Relative names are relative to the folder. All functions may be called in any thread.
class DataFolder {
 public:
  /// @param folder a relative path is relative to the working directory
  explicit DataFolder(const std::string& folder = defaultFolder(), bool allow_any_path = false);

  /// @brief The folder of nodes without the parameter: social_crowd in $ROS_HOME, or in ~/.ros.
  static std::string defaultFolder();

  /// @brief Absolute path.
  const std::string& folder() const { return folder_; }
  /// @brief Makes the folder if there is none and that is possible, so that users find it.
  void prepare() const;

  /// @brief Finds a file that has no path in the folder. @param name of a request @param folder this one
  using Find = std::function<std::string(const std::string& name, const std::string& folder)>;

  /// @brief Returns the absolute path of a name in a request, whether there is such a file or not.
  /// @throws InputError if it is empty or too long, leads out of the folder, also by links, or is neither a regular
  /// file nor a folder; the message does not tell whether a file outside exists
  std::string resolve(const std::string& name) const;
  /// @brief The same for a file that is to be read. @param find called if there is none in the folder: a shipped file
  /// may have that name
  std::string resolveToRead(const std::string& name, const Find& find) const;
  /// @brief The same for a file that is to be written; makes the folder.
  /// @throws InputError also if there is such a file and it may not be overwritten; FileError
  std::string resolveToWrite(const std::string& name, bool overwrite) const;

 private:
  std::string resolveInside(const std::string& name) const;

  std::string folder_;
  bool allows_any_path_;
};

/// @brief Reads ~data_folder and ~allow_any_path.
DataFolder readDataFolder(Parameters& parameters);

}  // namespace crowd
