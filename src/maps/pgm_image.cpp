#include <algorithm>
#include <charconv>
#include <system_error>

#include "common/text/quotes.h"
#include "maps/map_image.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

constexpr std::uint32_t GREATEST_SAMPLE = 65535;

bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Reads the words of a PGM file one after the other.
class PgmWords {
 public:
  explicit PgmWords(std::string_view content) : rest_(content) {}

  /// The next word, without comments before it; empty at the end of the file.
  std::string_view next() {
    skipBlanks();
    const auto end = std::find_if(rest_.begin(), rest_.end(), isBlank);
    return take(static_cast<std::size_t>(end - rest_.begin()));
  }

  /// The next word as a whole number up to `high`; `what` is its name in messages.
  std::uint32_t number(const std::string& what, std::uint32_t high) {
    const std::string_view word = next();
    std::uint32_t value = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_whole = !word.empty() && read.ec == std::errc() && read.ptr == word.data() + word.size();
    if (is_whole && value <= high) return value;
    const std::string got = word.empty() ? "the end of the file" : inQuotes(word);
    throw InputError(what + ": expected a whole number from 0 to " + std::to_string(high) + ", got " + got);
  }

  /// All that follows the one blank after the last word.
  std::string_view remainder() const { return rest_.substr(std::min<std::size_t>(1, rest_.size())); }

 private:
  std::string_view take(std::size_t count) {
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  void skipBlanks() {
    while (!rest_.empty() && (isBlank(rest_.front()) || rest_.front() == '#')) {
      take(rest_.front() == '#' ? std::min(rest_.find('\n'), rest_.size()) : 1);
    }
  }

  std::string_view rest_;
};

/// Fills the samples of an image and scales them.
class PgmSamples {
 public:
  PgmSamples(MapImage& image, std::uint32_t greatest) : image_(image), greatest_(greatest) {}

  void readText(PgmWords& words) {
    image_.samples.reserve(std::min(count(), words.remainder().size()));  // the header may lie
    while (image_.samples.size() < count()) add(words.number(nameOfNext(), greatest_));
    if (!words.next().empty()) throw InputError("expected the end of the file after " + pixels());
  }

  void readBytes(std::string_view bytes) {
    const std::size_t width = greatest_ > 255 ? 2 : 1;  // [bytes] of a sample, the high one first
    if (bytes.size() != width * count()) {
      throw InputError("expected " + std::to_string(width * count()) + " bytes for " + pixels() + ", got " +
                       std::to_string(bytes.size()));
    }
    image_.samples.reserve(count());
    for (std::size_t i = 0; i < bytes.size(); i += width) {
      const std::uint32_t value = width == 1 ? byte(bytes[i]) : 256 * byte(bytes[i]) + byte(bytes[i + 1]);
      if (value > greatest_) {
        throw InputError(nameOfNext() + ": expected a value from 0 to " + std::to_string(greatest_) + ", got " +
                         std::to_string(value));
      }
      add(value);
    }
  }

 private:
  static std::uint32_t byte(char c) { return static_cast<unsigned char>(c); }
  std::size_t count() const { return std::size_t{image_.width} * image_.height; }
  std::string pixels() const {
    return std::to_string(image_.width) + " x " + std::to_string(image_.height) + " pixels";
  }
  std::string nameOfNext() const {
    return "pixel " + std::to_string(image_.samples.size() + 1) + " of " + std::to_string(count());
  }
  void add(std::uint32_t value) { image_.samples.push_back(static_cast<std::uint8_t>(value * 255 / greatest_)); }

  MapImage& image_;
  std::uint32_t greatest_;
};

}  // namespace

MapImage parsePgm(std::string_view content) {
  PgmWords words(content);
  const std::string_view magic = words.next();
  if (magic != "P2" && magic != "P5") throw InputError("expected P2 or P5 as the first word");
  MapImage image;
  image.width = words.number("width", UINT32_MAX);
  image.height = words.number("height", UINT32_MAX);
  requireImageSize(image.width, image.height);
  const std::uint32_t greatest = words.number("greatest value of a pixel", GREATEST_SAMPLE);
  if (greatest == 0) throw InputError("greatest value of a pixel: expected at least 1, got 0");
  PgmSamples samples(image, greatest);
  if (magic == "P2") {
    samples.readText(words);
  } else {
    samples.readBytes(words.remainder());
  }
  return image;
}

}  // namespace crowd
