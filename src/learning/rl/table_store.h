#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "common/text/enum_names.h"
#include "learning/rl/q_table.h"

namespace crowd {

/// @brief shared: all users learn in one table; own: each user learns in a copy of its own.
enum class TableUse { SHARED, OWN };
/// @brief How a table is combined with the table that a user already has.
enum class TakeMethod { REPLACE, MERGE };

inline constexpr EnumNames<TableUse, 2> TABLE_USES{"tables", {"shared", "own"}};
inline constexpr EnumNames<TakeMethod, 2> TAKE_METHODS{"method", {"replace", "merge"}};

/// @brief The Q-tables of several users, numbered 0, 1, 2 ...; users are agents of a learner. With SHARED, all users
/// have the base table; with OWN, each has a copy of the base table, made when it is first written to.
///
/// Not thread-safe, except that functions that are const may run concurrently.
class TableStore {
 public:
  /// @brief Stands for the base table: that of all users (SHARED), or that new users begin with (OWN).
  static constexpr std::uint32_t BASE = UINT32_MAX;

  TableStore(QTable table, TableUse use) : use_(use), base_(std::make_shared<QTable>(std::move(table))) {}

  TableUse use() const { return use_; }
  /// @brief Adds a user; its number is the number of users before.
  void addUser();
  /// @brief Returns the table of a user. @param user its number, or BASE
  const QTable& table(std::uint32_t user) const { return *placeOf(user); }
  /// @brief Returns the same table for writing; valid until the next call of a function that is not const.
  QTable& writable(std::uint32_t user) {
    TablePointer& place = placeOf(user);
    if (use_ == TableUse::OWN && place.use_count() > 1) place = std::make_shared<QTable>(*place);
    return *place;
  }

  /// @brief Separates what is learned from now on from the previous contents of the tables; the first call only.
  void beginSources();
  /// @brief Names the visits that a user made since beginSources(), if it was called.
  void nameSource(std::uint32_t user, SourceId name);

  /// @brief Result of take() for one table.
  struct Taken {
    std::uint64_t new_visits = 0;  ///< visits that the table did not have before
    std::uint64_t visits = 0;      ///< visits that it has now
  };
  /// @brief Result of take() for all users.
  struct TakenByAll {
    Taken base;                  ///< with shared tables for all users, else for new users
    std::vector<Taken> by_user;  ///< with own tables
  };
  /// @brief Gives a table of the same shape to all present and future users; begins sources.
  TakenByAll take(QTable table, TakeMethod method);
  /// @brief Gives a table of the same shape to one user; with SHARED, to all users. Begins sources.
  Taken take(std::uint32_t user, QTable table, TakeMethod method);
  /// @brief Replaces the tables of all users, as if they had learned the whole table themselves.
  void restart(QTable table);
  /// @brief Replaces the table of one user in the same way. @param user its number, or BASE for new users only
  void restart(std::uint32_t user, QTable table) { placeOf(user) = std::make_shared<QTable>(std::move(table)); }

 private:
  using TablePointer = std::shared_ptr<QTable>;

  const TablePointer& placeOf(std::uint32_t user) const {
    return use_ == TableUse::SHARED || user == BASE ? base_ : own_[user];
  }
  TablePointer& placeOf(std::uint32_t user) { return use_ == TableUse::SHARED || user == BASE ? base_ : own_[user]; }
  static Taken give(TablePointer& place, const QTable& table, TakeMethod method);

  TableUse use_;
  TablePointer base_;
  std::vector<TablePointer> own_;  // by user; empty with SHARED
  bool has_own_sources_ = false;   // whether learning began a source of its own
};

}  // namespace crowd
