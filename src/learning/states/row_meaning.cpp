#include "learning/states/row_meaning.h"

#include <locale>
#include <sstream>

namespace crowd {
namespace {

/// A YAML list of items, each as write(item).
template <typename Item, typename Write>
std::string listOf(const std::vector<Item>& items, const Write& write) {
  std::string text;
  for (const Item& item : items) text += (text.empty() ? "" : ", ") + write(item);
  return "[" + text + "]";
}

std::string scalarOf(const std::string& text) { return "'" + text + "'"; }

}  // namespace

std::string RowMeaning::text() const {
  std::string text = "quantities:\n";
  for (const RowQuantity& quantity : quantities) {
    text += "- {name: " + scalarOf(quantity.name) + ", classes: " + listOf(quantity.classes, scalarOf) + "}\n";
  }
  const auto number = [](int value) { return std::to_string(value); };
  text += "rows: " + listOf(rows, [&](const std::vector<int>& row) { return listOf(row, number); });
  return text + "\nextra: " + (has_terminal ? "[arrival]" : "[]");
}

std::string shortText(double number) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << number;
  return text.str();
}

std::vector<std::string> namesOf(const EvenSectors& sectors) {
  if (sectors.count() == 8) {
    return {"ahead", "ahead left", "left", "behind left", "behind", "behind right", "right", "ahead right"};
  }
  std::vector<std::string> names;
  for (int i = 0; i < sectors.count(); ++i) {
    const double middle = 360.0 / sectors.count() * i;
    names.push_back(shortText(middle < 180.0 ? middle : middle - 360.0) + "°");
  }
  return names;
}

std::vector<std::string> namesOf(const MirroredSectors& sectors) {
  std::vector<std::string> names;
  for (const char* const side : {"left ", "right "}) {
    double inner = 0.0;
    for (const double outer : sectors.degrees()) {
      names.push_back(side + shortText(inner) + "-" + shortText(outer) + "°");
      inner = outer;
    }
  }
  return names;
}

std::vector<std::string> namesOf(const ObstacleSectors& sectors) {
  return sectors.byLimits() != nullptr ? namesOf(*sectors.byLimits()) : namesOf(sectors.even());
}

std::vector<std::string> namesOf(const DistanceClasses& distances) {
  return {"up to " + shortText(distances.collision_radius) + " m",
          "up to " + shortText(distances.vision_radius) + " m"};
}

std::vector<std::string> classNames(const std::vector<double>& limits, const std::string& unit) {
  if (limits.empty()) return {"any"};
  std::vector<std::string> names = {"< " + shortText(limits.front()) + unit};
  for (std::size_t i = 1; i < limits.size(); ++i) {
    names.push_back(shortText(limits[i - 1]) + "-" + shortText(limits[i]) + unit);
  }
  names.push_back("≥ " + shortText(limits.back()) + unit);
  return names;
}

}  // namespace crowd
