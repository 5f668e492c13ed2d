#include "scenario/reading/scenario_files.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "common/files/file_access.h"
#include "common/files/library_file.h"
#include "common/text/quotes.h"
#include "common/text/suggestions.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

namespace fs = std::filesystem;

constexpr const char* SCENARIO_EXTENSION = ".yaml";
constexpr std::size_t NAMES_IN_ERROR = 12;  // the nearest ones

bool isFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

/// A few levels above the library, as in PREFIX/lib/libNAME.so.
fs::path installedScenarios() {
  std::error_code ignored;
  fs::path folder = fs::canonical(libraryFile(), ignored).parent_path();
  for (int level = 0; level < 2; ++level) {
    folder = folder.parent_path();
    if (isFolder(folder / SCENARIOS_IN_PREFIX)) return folder / SCENARIOS_IN_PREFIX;
  }
  return {};
}

/// The names of the scenario files of a folder, without those of its folders, sorted.
std::vector<std::string> scenariosIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const std::string& name : namesIn(folder.string())) {
    const fs::path file(name);
    if (file.extension() == SCENARIO_EXTENSION) names.push_back(file.stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// A folder and the folders in it, sorted.
std::vector<fs::path> withFolders(const fs::path& folder) {
  std::vector<fs::path> folders;
  for (const std::string& name : namesIn(folder.string())) {
    if (isFolder(folder / name)) folders.push_back(folder / name);
  }
  std::sort(folders.begin(), folders.end());
  folders.insert(folders.begin(), folder);
  return folders;
}

/// The file of a name in a folder, or in one of its folders; empty if there is none.
fs::path fileNamed(const std::string& name, const fs::path& folder) {
  for (const fs::path& one : withFolders(folder)) {
    fs::path file = one / (name + SCENARIO_EXTENSION);
    if (mayBeFile(file.string())) return file;
  }
  return {};
}

/// How a scenario of that name can be given: as a bare name is, or as a file in the same folder as another path.
std::string asGiven(const std::string& name, const fs::path& path, bool is_bare) {
  return is_bare ? name : (path.parent_path() / (name + SCENARIO_EXTENSION)).string();
}

[[noreturn]] void throwNoScenario(const fs::path& path, const fs::path& file, const fs::path& folder, bool is_bare) {
  const fs::path searched = fs::absolute(file).lexically_normal().parent_path();
  std::vector<std::string> names =
      sortedByNearness(path.stem().string(), is_bare ? scenarioNames(folder.string()) : scenariosIn(searched));
  std::string nearest = nearestName(path.stem().string(), names);
  if (!nearest.empty()) nearest = asGiven(nearest, path, is_bare);
  const std::string beside = is_bare ? nearestName(path.stem().string(), scenariosIn(searched)) : "";
  if (!beside.empty() && (nearest.empty() || path.has_extension())) nearest = beside + SCENARIO_EXTENSION;
  const std::string hint = nearest.empty() ? "" : ", did you mean '" + nearest + "'?";
  for (std::string& name : names) name = asGiven(name, path, is_bare);
  std::string text = "no scenario " + inQuotes(path.string()) + (hint.empty() ? ": there" : hint + " There");
  text += " is no file " + fs::absolute(file).lexically_normal().string();
  if (is_bare) text += ", and in " + folder.string() + " none of that name";
  if (!names.empty())
    text += "; there " + std::string(names.size() == 1 ? "is " : "are ") + joinNames(names, "", NAMES_IN_ERROR);
  throw InputError(text);
}

}  // namespace

std::string shippedScenarios() {
  const fs::path installed = installedScenarios();
  return installed.empty() ? std::string(SCENARIOS_IN_SOURCE) : installed.string();
}

std::vector<std::string> scenarioNames(const std::string& folder) {
  std::vector<std::string> names;
  for (const fs::path& one : withFolders(folder)) {
    const std::vector<std::string> found = scenariosIn(one);
    names.insert(names.end(), found.begin(), found.end());
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::string findScenario(const std::string& name_or_file, const std::string& base, const std::string& folder) {
  if (name_or_file.empty()) throw InputError("expected a scenario file or name, got nothing");
  const fs::path path(name_or_file);
  const fs::path file = fs::path(base) / path;
  const bool is_bare = !path.has_parent_path() && (!path.has_extension() || path.extension() == SCENARIO_EXTENSION);
  const bool is_plainly_a_folder = !is_bare && isFolder(file);  // reported when it is read
  if (mayBeFile(file.string()) || is_plainly_a_folder) return file.lexically_normal().string();
  const fs::path named = is_bare ? fileNamed(path.stem().string(), folder) : fs::path();
  if (!named.empty()) return named.string();
  throwNoScenario(path, file, folder, is_bare);
}

}  // namespace crowd
