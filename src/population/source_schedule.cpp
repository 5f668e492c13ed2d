#include "population/source_schedule.h"

#include "common/portable_math.h"

namespace crowd {
SourceSchedule::SourceSchedule(const SourceDescription& source, const KeyedRandom& random)
    : source_(&source), random_(random), next_(timeOf(0, source.from)) {}

bool SourceSchedule::isOver() const { return next_ == INFINITE; }

void SourceSchedule::end() { next_ = INFINITE; }

void SourceSchedule::advance() {
  ++number_;
  next_ = timeOf(number_, next_);
}

double SourceSchedule::timeOf(std::uint64_t number, double before) const {
  if (number >= source_->count) return INFINITE;
  if (!source_->rate) return number < source_->times.size() ? source_->times[number] : INFINITE;
  double time = 0.0;
  if (source_->regular) {
    time = source_->from + static_cast<double>(number) / *source_->rate;
  } else {
    time = before - portable::log(1.0 - random_.with(number).uniform()) / *source_->rate;
  }
  return time < source_->until ? time : INFINITE;
}

}  // namespace crowd
