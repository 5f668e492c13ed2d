#include "common/text/numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <locale>

#include "common/random.h"

namespace crowd::numbers_test {
namespace {

using Limits = std::numeric_limits<double>;

std::uint64_t bitsOf(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

double fromBits(std::uint64_t bits) {
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// The significant digits of a number's text: those before the exponent, without zeros at either end.
int significantDigits(const std::string& text) {
  std::string digits;
  for (const char letter : text.substr(0, text.find('e'))) {
    if (letter >= '0' && letter <= '9') digits += letter;
  }
  const std::size_t first = digits.find_first_not_of('0');
  return first == std::string::npos ? 0 : static_cast<int>(digits.find_last_not_of('0') - first + 1);
}

void expectRoundTrip(double value) {
  const std::string text = toText(value);
  const std::optional<double> read = toNumber(text);
  ASSERT_TRUE(read.has_value()) << text;
  EXPECT_EQ(bitsOf(*read), bitsOf(value)) << text;
}

void expectShortest(double value) {
  const int digits = significantDigits(toText(value));
  if (digits < 2) return;
  std::array<char, 64> shorter{};
  std::snprintf(shorter.data(), shorter.size(), "%.*e", digits - 2, value);  // one digit fewer
  EXPECT_NE(std::strtod(shorter.data(), nullptr), value) << toText(value) << " is longer than " << shorter.data();
}

TEST(ToText, WritesTheShortestDecimal) {
  EXPECT_EQ(toText(0.0), "0");
  EXPECT_EQ(toText(-0.0), "-0");
  EXPECT_EQ(toText(1.0), "1");
  EXPECT_EQ(toText(-2.5), "-2.5");
  EXPECT_EQ(toText(0.1), "0.1");
  EXPECT_EQ(toText(180.0), "180");
  EXPECT_EQ(toText(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(toText(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(toText(1e22), "1e+22");
}

TEST(ToText, WritesNonFiniteNumbers) {
  EXPECT_EQ(toText(Limits::quiet_NaN()), "nan");
  EXPECT_EQ(toText(Limits::infinity()), "inf");
  EXPECT_EQ(toText(-Limits::infinity()), "-inf");
}

TEST(ToText, ExtremeValuesReadBackBitForBit) {
  for (const double value : {0.0, Limits::denorm_min(), Limits::min(), Limits::epsilon(), Limits::max(), 1.0}) {
    for (const double neighbour : {value, std::nextafter(value, 0.0), std::nextafter(value, Limits::max())}) {
      expectRoundTrip(neighbour);
      expectRoundTrip(-neighbour);
    }
  }
}

TEST(ToText, RandomValuesReadBackBitForBit) {
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const std::uint64_t bits = random.next();
    const double value = fromBits(bits);
    if (std::isfinite(value)) expectRoundTrip(value);
    expectRoundTrip(fromBits(bits & 0x800FFFFFFFFFFFFFULL));  // exponent 0: subnormal
    expectRoundTrip(random.uniform(-100.0, 100.0));           // as in Q-tables
  }
}

TEST(ToText, WritesNoUnnecessaryDigit) {
  expectShortest(Limits::max());
  expectShortest(Limits::min());
  expectShortest(Limits::denorm_min());
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    expectShortest(random.uniform(-100.0, 100.0));
    expectShortest(std::round(random.uniform(-1e4, 1e4)) / 1000.0);
  }
}

TEST(ToNumber, AcceptsAllDecimalNotations) {
  EXPECT_EQ(toNumber("1"), 1.0);
  EXPECT_EQ(toNumber("+1"), 1.0);
  EXPECT_EQ(toNumber("-1"), -1.0);
  EXPECT_EQ(toNumber("007"), 7.0);
  EXPECT_EQ(toNumber(".5"), 0.5);
  EXPECT_EQ(toNumber("5."), 5.0);
  EXPECT_EQ(toNumber("1e3"), 1000.0);
  EXPECT_EQ(toNumber("-2.5E-1"), -0.25);
  EXPECT_EQ(toNumber("1e+308"), 1e308);
  EXPECT_EQ(toNumber("4.9406564584124654e-324"), Limits::denorm_min());
  EXPECT_TRUE(std::signbit(toNumber("-0").value()));
}

TEST(ToNumber, AcceptsNonFiniteNumbers) {
  EXPECT_TRUE(std::isnan(toNumber("nan").value()));
  EXPECT_EQ(toNumber("inf"), Limits::infinity());
  EXPECT_EQ(toNumber("-inf"), -Limits::infinity());
}

TEST(ToNumber, RefusesTextThatIsNotOneNumber) {
  for (const char* const text :
       {"",    "+",    "-",   ".",   "e5",   "one", "1x",    "x1",    " 1",    "1 ",      "\t1",   "1\n",
        "1 2", "0x10", "1,5", "1;",  "1e",   "1e+", "1e5.5", "1.2.3", "1_000", "1'000",   "--1",   "++1",
        "+-1", "-+1",  "1-",  "1+1", "1e 5", "0b1", "1f",    "1d",    "nano",  "1e99999", "1e400", "-1e400"}) {
    EXPECT_FALSE(toNumber(text).has_value()) << "'" << text << "' was read as " << toNumber(text).value_or(0.0);
  }
  EXPECT_FALSE(toNumber(std::string_view("1\0", 2)).has_value());
}

TEST(ToNumber, ReadsOnlyItsText) {
  EXPECT_EQ(toNumber(std::string_view("12345").substr(0, 2)), 12.0);
  EXPECT_EQ(toNumber(std::string_view("1e5").substr(0, 1)), 1.0);
}

/// Decimal commas, and points between thousands.
class GermanNumbers : public std::numpunct<char> {
 protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// Sets the locale of C++ and, if the system has a German one, that of C; restores both.
class GermanLocale {
 public:
  GermanLocale() : before_(std::locale::global(std::locale(std::locale::classic(), new GermanNumbers))) {
    for (const char* const name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"}) {
      if (std::setlocale(LC_NUMERIC, name) != nullptr) break;
    }
  }
  ~GermanLocale() {
    std::locale::global(before_);
    std::setlocale(LC_NUMERIC, "C");
  }
  GermanLocale(const GermanLocale&) = delete;
  GermanLocale& operator=(const GermanLocale&) = delete;

 private:
  std::locale before_;
};

TEST(Numbers, DoNotDependOnTheLocale) {
  const GermanLocale locale;
  EXPECT_EQ(toText(1234567.5), "1234567.5");
  EXPECT_EQ(toText(0.25), "0.25");
  EXPECT_EQ(toNumber("1234567.5"), 1234567.5);
  EXPECT_FALSE(toNumber("0,25").has_value());
  EXPECT_FALSE(toNumber("1.234.567").has_value());
}

}  // namespace
}  // namespace crowd::numbers_test
