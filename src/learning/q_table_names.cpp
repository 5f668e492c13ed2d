#include "learning/q_table_names.h"

#include <filesystem>

#include "common/files/file_access.h"
#include "common/text/quotes.h"
#include "common/text/suggestions.h"
#include "scenario/reading/scenario_files.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

namespace fs = std::filesystem;

constexpr const char* Q_TABLE_EXTENSION = ".txt";

/// The folder beside that of the scenarios.
fs::path shippedQTables() { return fs::path(shippedScenarios()).parent_path() / "q_tables"; }

std::vector<std::string> qTablesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const std::string& name : namesIn(folder.string())) {
    const fs::path file(name);
    if (file.extension() == Q_TABLE_EXTENSION) names.push_back(file.stem().string());
  }
  return names;
}

}  // namespace

std::string findQTable(const std::string& name_or_file, const std::string& base) {
  const fs::path path(name_or_file);
  const fs::path file = fs::path(base) / path;
  const bool is_bare = !path.has_parent_path() && (!path.has_extension() || path.extension() == Q_TABLE_EXTENSION);
  std::error_code ignored;
  if (!is_bare || mayBeFile(file.string())) {
    return base.empty() ? name_or_file : file.lexically_normal().string();
  }
  const fs::path folder = shippedQTables();
  const fs::path named = folder / (path.stem().string() + Q_TABLE_EXTENSION);
  if (fs::exists(named, ignored)) return named.string();
  const std::vector<std::string> names = sortedByNearness(path.stem().string(), qTablesIn(folder));
  const std::string nearest = nearestName(path.stem().string(), names);
  throw InputError(
      "no Q-table " + inQuotes(name_or_file) + (nearest.empty() ? "" : ", did you mean '" + nearest + "'?") +
      (nearest.empty() ? ": there" : " There") + " is no file " + fs::absolute(file).string() + ", and in " +
      folder.string() + " none of that name" + (names.empty() ? "" : "; there are " + joinNames(names)));
}

}  // namespace crowd
