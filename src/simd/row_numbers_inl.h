// Included once for each instruction set.
#if defined(CROWD_ROW_NUMBERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROWD_ROW_NUMBERS_INL
#undef CROWD_ROW_NUMBERS_INL
#else
#define CROWD_ROW_NUMBERS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "simd/row_numbers.h"

HWY_BEFORE_NAMESPACE();
namespace crowd::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t MAX_CLASS_LANES = 8;  // three registers fit VALUES_PADDED
using ClassValues = hn::CappedTag<float, MAX_CLASS_LANES>;
using RowNumbers = hn::RebindToUnsigned<ClassValues>;

HWY_INLINE hn::Vec<RowNumbers> countReached(hn::Vec<RowNumbers> rows, hn::Vec<ClassValues> values,
                                            hn::Vec<ClassValues> limit) {
  const auto reached = hn::BitCast(RowNumbers(), hn::VecFromMask(ClassValues(), hn::Ge(values, limit)));
  return hn::Sub(rows, reached);  // true is -1
}

/// Writes a register of row numbers to rows[first...], without those at index `count` or above.
HWY_INLINE void writeRows(hn::Vec<RowNumbers> numbers, std::size_t first, std::size_t count, std::uint32_t* rows) {
  const RowNumbers d;
  const std::size_t lanes = hn::Lanes(d);
  if (first + lanes <= count) return hn::StoreU(numbers, d, rows + first);
  alignas(64) std::uint32_t last[MAX_CLASS_LANES];  // NOLINT(cppcoreguidelines-avoid-c-arrays)
  hn::Store(numbers, d, last);
  for (std::size_t i = first; i < count; ++i) rows[i] = last[i - first];
}

/// Processes three registers at a time, so that each limit is read only once for them.
inline void findRowNumbers(const ClassDigit* digits, std::size_t digit_count, LastDigit last, std::size_t count,
                           std::uint32_t* rows) {
  const ClassValues d;
  const RowNumbers du;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t i = 0; i < count; i += 3 * lanes) {
    auto rows_a = hn::Zero(du);
    auto rows_b = rows_a;
    auto rows_c = rows_a;
    for (const ClassDigit* digit = digits; digit != digits + digit_count; ++digit) {
      const auto classes = hn::Set(du, static_cast<std::uint32_t>(digit->limit_count + 1));
      const auto sign = hn::Set(d, digit->sign);
      const auto a = hn::Mul(hn::LoadU(d, digit->values + i), sign);
      const auto b = hn::Mul(hn::LoadU(d, digit->values + i + lanes), sign);
      const auto c = hn::Mul(hn::LoadU(d, digit->values + i + 2 * lanes), sign);
      rows_a = hn::Mul(rows_a, classes);
      rows_b = hn::Mul(rows_b, classes);
      rows_c = hn::Mul(rows_c, classes);
      for (std::size_t k = 0; k < digit->limit_count; ++k) {
        const auto limit = hn::Set(d, digit->limits[k]);
        rows_a = countReached(rows_a, a, limit);
        rows_b = countReached(rows_b, b, limit);
        rows_c = countReached(rows_c, c, limit);
      }
    }
    const auto classes = hn::Set(du, last.classes);
    const auto last_digit = hn::Set(du, last.digit);
    writeRows(hn::Add(hn::Mul(rows_a, classes), last_digit), i, count, rows);
    writeRows(hn::Add(hn::Mul(rows_b, classes), last_digit), i + lanes, count, rows);
    writeRows(hn::Add(hn::Mul(rows_c, classes), last_digit), i + 2 * lanes, count, rows);
  }
}

}  // namespace crowd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
