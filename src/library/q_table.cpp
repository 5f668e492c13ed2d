#include "social_crowd/q_table.h"

#include "learning/q_table_file.h"
#include "learning/q_table_names.h"
#include "social_crowd/errors.h"

namespace crowd::library {

QTable QTable::load(const std::string& name_or_file) {
  return QTable(std::make_shared<TrainedTable>(loadQTable(findQTable(name_or_file))));
}

void QTable::save(const std::string& file) const { saveQTable(file, *trained_); }

Vision QTable::vision() const {
  const crowd::Vision vision = trained_->model.vision();
  return {vision.radius, vision.max_neighbours, vision.occlusion, vision.wall_distance, toPublic(*vision.motion)};
}

std::string QTable::model() const { return trained_->model.spec(); }
std::uint64_t QTable::decisions() const { return trained_->decisions; }
std::size_t QTable::rows() const { return trained_->table.rows(); }
std::size_t QTable::actions() const { return trained_->table.actions(); }

double QTable::value(std::size_t row, std::size_t action) const {
  if (row >= rows() || action >= actions()) {
    throw InputError("expected a row below " + std::to_string(rows()) + " and an action below " +
                     std::to_string(actions()) + ", got " + std::to_string(row) + " and " + std::to_string(action));
  }
  return trained_->table.value(static_cast<Row>(row), static_cast<crowd::Action>(action));
}

}  // namespace crowd::library
