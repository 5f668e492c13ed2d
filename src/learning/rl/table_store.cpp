#include "learning/rl/table_store.h"

namespace crowd {

void TableStore::addUser() {
  if (use_ == TableUse::OWN) own_.push_back(base_);
}

void TableStore::beginSources() {
  if (has_own_sources_) return;
  base_->beginSource();  // no user has a table of its own yet
  has_own_sources_ = true;
}

void TableStore::nameSource(std::uint32_t user, SourceId name) {
  // Without learning, a table has no own visits, or only those of a file, which are identified by its content.
  if (has_own_sources_) placeOf(user)->nameSource(name);
}

TableStore::Taken TableStore::give(TablePointer& place, const QTable& table, TakeMethod method) {
  if (method == TakeMethod::REPLACE) {
    const Taken taken = {place->newVisitsOf(table), table.allVisits()};
    place = std::make_shared<QTable>(table);
    return taken;
  }
  auto merged = std::make_shared<QTable>(*place);
  merged->nameSource(newSource());
  const std::uint64_t news = merged->merge(table);
  place = std::move(merged);
  return {news, place->allVisits()};
}

TableStore::TakenByAll TableStore::take(QTable table, TakeMethod method) {
  beginSources();
  table.beginSource();
  TakenByAll taken;
  for (TablePointer& place : own_) taken.by_user.push_back(give(place, table, method));
  taken.base = give(base_, table, method);
  // After a replacement all users have the same table: one copy is enough until it is written to.
  if (method == TakeMethod::REPLACE) own_.assign(own_.size(), base_);
  return taken;
}

TableStore::Taken TableStore::take(std::uint32_t user, QTable table, TakeMethod method) {
  if (use_ == TableUse::SHARED) return take(std::move(table), method).base;
  beginSources();
  table.beginSource();
  return give(placeOf(user), table, method);
}

void TableStore::restart(QTable table) {
  base_ = std::make_shared<QTable>(std::move(table));
  own_.assign(own_.size(), base_);
}

}  // namespace crowd
