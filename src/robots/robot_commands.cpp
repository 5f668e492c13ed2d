#include "robots/robot_commands.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "social_crowd/errors.h"

namespace crowd {

std::uint64_t RobotCommands::ticksOf(double seconds) const {
  constexpr double TOLERANCE = 1e-9;  // [ticks], against rounding
  return static_cast<std::uint64_t>(std::max(0.0, std::ceil(seconds / tick_duration_ - TOLERANCE)));
}

void RobotCommands::begin(const std::vector<double>& timeouts, double tick_duration) {
  tick_duration_ = tick_duration;
  const bool are_known = timeouts.size() == records_.size();
  std::vector<Record> records(timeouts.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    records[i].timeout = ticksOf(timeouts[i]);
    records[i].heard = are_known && records_[i].heard;
    records[i].absent = are_known && records_[i].absent;
  }
  records_ = std::move(records);
}

bool RobotCommands::isHeld(const Record& record, std::uint64_t tick) {
  return record.taken_at && tick < *record.taken_at + record.timeout;
}

std::optional<CommandRefusal> RobotCommands::causeOf(const Record& record, const Twist& command, PublisherId publisher,
                                                     std::uint64_t tick) const {
  if (!command.isFinite()) return CommandRefusal::NOT_FINITE;
  if (isHeld(record, tick) && record.holder != publisher) return CommandRefusal::OTHER_PUBLISHER;
  return std::nullopt;
}

void RobotCommands::noteTiming(Record& record, std::uint64_t tick) const {
  if (!record.missed_at) {
    record.due = tick + period();
    return;
  }
  ++record.counts.late;
  record.due = *record.missed_at + period();
  while (record.due < tick) record.due += period();
  record.missed_at.reset();
}

std::optional<CommandRefusal> RobotCommands::take(RobotId robot, const Twist& command, PublisherId publisher,
                                                  std::uint64_t tick) {
  if (robot >= records_.size()) throw InputError("there is no robot " + std::to_string(robot));
  Record& record = records_[robot];
  const std::optional<CommandRefusal> cause = causeOf(record, command, publisher, tick);
  if (cause) {
    ++record.counts.refused[static_cast<std::size_t>(*cause)];
    return cause;
  }
  ++record.counts.taken;
  const bool has_one = record.taken_at == tick && tick < record.due;
  record.counts.newer += has_one ? 1 : 0;
  if (!has_one) noteTiming(record, tick);
  record.command = command;
  record.taken_at = tick;
  record.holder = publisher;
  record.is_stopped = false;
  record.heard = true;
  record.absent = false;
  record.misses = 0;
  return std::nullopt;
}

std::optional<PublisherId> RobotCommands::holderOf(RobotId robot, std::uint64_t tick) const {
  const Record& record = records_[robot];
  return isHeld(record, tick) ? std::optional(record.holder) : std::nullopt;
}

bool RobotCommands::isAwaited(RobotId robot, std::uint64_t tick) const {
  const Record& record = records_[robot];
  return settings_.lockstep && record.heard && !record.absent && tick >= record.due;
}

bool RobotCommands::isUnattended(RobotId robot) const {
  return settings_.lockstep && (!records_[robot].heard || records_[robot].absent);
}

bool RobotCommands::isAnyAwaited(std::uint64_t tick) const {
  for (RobotId robot = 0; robot < records_.size(); ++robot) {
    if (isAwaited(robot, tick)) return true;
  }
  return false;
}

std::vector<RobotId> RobotCommands::giveUp(std::uint64_t tick) {
  std::vector<RobotId> absent;
  for (RobotId robot = 0; robot < records_.size(); ++robot) {
    if (!isAwaited(robot, tick)) continue;
    Record& record = records_[robot];
    if (record.taken_at == tick) {  // a late one
      record.due = tick + period();
      continue;
    }
    ++record.counts.missed;
    if (!record.missed_at) record.missed_at = tick;
    if (++record.misses < settings_.misses_until_absent) continue;
    record.absent = true;
    record.missed_at.reset();
    absent.push_back(robot);
  }
  return absent;
}

Twist RobotCommands::commandFor(RobotId robot, std::uint64_t tick) {
  Record& record = records_[robot];
  if (isHeld(record, tick)) return record.command;
  if (!record.is_stopped) ++record.counts.timeouts;
  record.is_stopped = true;
  return Twist();
}

}  // namespace crowd
