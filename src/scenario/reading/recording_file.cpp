#include "scenario/reading/recording_file.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <regex>
#include <string_view>
#include <tuple>
#include <utility>

#include "common/files/files.h"
#include "common/text/numbers.h"
#include "common/text/quotes.h"
#include "geometry/limits.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

constexpr std::string_view CSV_HEADER = "instance,tick,agent,x,y";
constexpr std::string_view BLANKS = " \t\r\v\f";
constexpr std::size_t OBSMAT_COLUMNS = 8;
constexpr double OBSMAT_PERIOD = 0.4;  // [s] between two annotated frames
constexpr double MOST_WHOLE = 9e15;    // doubles below are exact

using LineWords = std::vector<std::string_view>;

/// A row of a file, whatever its format is.
struct RecordedRow {
  std::uint64_t person = 0;
  std::uint64_t frame = 0;
  Vector2 place = Vector2::Zero();
  std::size_t line = 0;
};

/// Where a format has its numbers.
struct RowColumns {
  std::size_t person, frame, x, y;
  const char* expected;
};
constexpr RowColumns CSV_COLUMNS{2, 1, 3, 4, "instance, tick and agent from 0, and finite x and y"};
constexpr RowColumns JUPEDSIM_COLUMNS{0, 1, 2, 3, "id and frame from 0, and finite x and y"};
constexpr RowColumns OBSMAT{1, 0, 2, 4, "8 columns: frame and person from 0, finite x, z and y, vx, vz and vy"};

LineWords splitAt(std::string_view text, std::string_view separators, bool skips_empty) {
  LineWords words;
  while (true) {
    const std::size_t end = std::min(text.find_first_of(separators), text.size());
    if (end > 0 || !skips_empty) words.push_back(text.substr(0, end));
    if (end == text.size()) return words;
    text.remove_prefix(end + 1);
  }
}

bool isBlank(std::string_view line) { return line.find_first_not_of(BLANKS) == std::string_view::npos; }

/// The lines of a file, and the rows that a format makes of them.
class RecordingText {
 public:
  RecordingText(const std::string& file, std::string_view content) : file_(file), content_(content) {}

  /// Calls work(line) for all lines that are not blank; number() is the one of the present line, from 1.
  template <typename Work>
  void forEachLine(const Work& work) {
    number_ = 0;
    for (std::size_t begin = 0; begin < content_.size();) {
      const std::size_t end = std::min(content_.find('\n', begin), content_.size());
      ++number_;
      const std::string_view line = content_.substr(begin, end - begin);
      if (!isBlank(line)) work(line);
      begin = end + 1;
    }
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(file_ + ":" + std::to_string(number_) + ": " + problem);
  }
  [[noreturn]] void failExpected(const std::string& expected, std::string_view line) const {
    fail("expected " + expected + ", got " + inQuotes(std::string(line)));
  }

  std::uint64_t whole(const LineWords& words, std::size_t column, const char* expected, std::string_view line) const {
    const std::optional<double> value = column < words.size() ? toNumber(words[column]) : std::nullopt;
    const bool is_whole = value && *value >= 0.0 && *value <= MOST_WHOLE && std::floor(*value) == *value;
    if (!is_whole) failExpected(expected, line);
    return static_cast<std::uint64_t>(*value);
  }

  void add(const LineWords& words, const RowColumns& columns, double scale, std::string_view line) {
    if (rows_.size() == limits::SAMPLES) fail("expected at most " + std::to_string(limits::SAMPLES) + " positions");
    RecordedRow row;
    row.person = whole(words, columns.person, columns.expected, line);
    row.frame = whole(words, columns.frame, columns.expected, line);
    row.place = {coordinate(words, columns.x, scale, columns, line),
                 coordinate(words, columns.y, scale, columns, line)};
    row.line = number_;
    rows_.push_back(row);
  }

  /// The walks of all rows.
  std::map<std::uint64_t, std::vector<Recording::Sample>> collect(const char* person, const char* frame) {
    if (rows_.empty()) throw InputError(file_ + ": has no trajectory");
    const auto key = [](const RecordedRow& row) { return std::make_tuple(row.person, row.frame, row.line); };
    std::sort(rows_.begin(), rows_.end(), [&](const RecordedRow& a, const RecordedRow& b) { return key(a) < key(b); });
    std::map<std::uint64_t, std::vector<Recording::Sample>> walks;
    for (const RecordedRow& row : rows_) {
      std::vector<Recording::Sample>& walk = walks[row.person];
      if (!walk.empty() && walk.back().frame == row.frame) {
        number_ = row.line;
        fail(std::string(person) + " " + std::to_string(row.person) + " is in " + frame + " " +
             std::to_string(row.frame) + " for the second time");
      }
      walk.push_back({row.frame, row.place});
    }
    return walks;
  }

  const std::string& file() const { return file_; }

 private:
  double coordinate(const LineWords& words, std::size_t column, double scale, const RowColumns& columns,
                    std::string_view line) const {
    const std::optional<double> value = column < words.size() ? toNumber(words[column]) : std::nullopt;
    if (!value || !std::isfinite(*value)) failExpected(columns.expected, line);
    const std::string refusal = refusalOf(scale * *value, limits::PLACE);
    if (!refusal.empty()) failExpected(refusal, line);
    return scale * *value;
  }

  const std::string& file_;
  std::string_view content_;
  std::size_t number_ = 0;
  std::vector<RecordedRow> rows_;
};

Recording readCsv(RecordingText& text, std::string_view content, std::optional<std::uint64_t> wanted) {
  std::uint64_t lowest = 0;
  std::uint64_t highest = 0;
  bool is_header = true;
  bool found = false;
  bool any = false;
  text.forEachLine([&](std::string_view line) {
    if (line.back() == '\r') line.remove_suffix(1);
    if (std::exchange(is_header, false)) {
      if (line != CSV_HEADER) text.failExpected("the header " + std::string(CSV_HEADER), line);
      return;
    }
    const LineWords words = splitAt(line, ",", false);
    if (words.size() != 5) text.failExpected(CSV_COLUMNS.expected, line);
    const std::uint64_t instance = text.whole(words, 0, CSV_COLUMNS.expected, line);
    if (!wanted) wanted = instance;
    lowest = any ? std::min(lowest, instance) : instance;
    highest = any ? std::max(highest, instance) : instance;
    any = true;
    if (instance != *wanted) return;
    found = true;
    text.add(words, CSV_COLUMNS, 1.0, line);
  });
  if (any && !found) {
    throw InputError(text.file() + ": has no instance " + std::to_string(*wanted) + ", expected " +
                     std::to_string(lowest) + (lowest == highest ? "" : " to " + std::to_string(highest)));
  }
  if (content.back() != '\n') text.fail("the last line is not complete, as in a file that was cut off");
  return {text.collect("agent", "tick"), std::nullopt};
}

Recording readJuPedSim(RecordingText& text) {
  static const std::regex RATE(R"(framerate\s*:?\s*([-+.\deE]+))");
  static const std::regex CENTIMETRES("[xX]/cm|in cm");
  std::optional<double> frame_duration;
  double scale = 1.0;
  text.forEachLine([&](std::string_view line) {
    if (line.front() != '#') return text.add(splitAt(line, BLANKS, true), JUPEDSIM_COLUMNS, scale, line);
    const std::string comment(line.substr(0, 1000));
    std::smatch match;
    if (!frame_duration && std::regex_search(comment, match, RATE)) {
      const std::optional<double> rate = toNumber(match[1].str());
      const bool is_rate = rate && refusalOf(*rate, limits::FRAME_RATE).empty();
      if (!is_rate) text.failExpected("a frame rate above 0, at most 1e6 Hz", match[1].str());
      frame_duration = 1.0 / *rate;
    }
    if (std::regex_search(comment, CENTIMETRES)) scale = 0.01;
  });
  return {text.collect("person", "frame"), frame_duration};
}

/// The most frequent number of frames between two rows of a person; of several the first; 0: there are none.
std::uint64_t usualStep(const Recording& recording) {
  struct Count {
    std::size_t of = 0;
    std::size_t first = 0;  // when it was counted first
  };
  std::map<std::uint64_t, Count> counts;
  for (const auto& [person, walk] : recording.walks) {
    for (std::size_t i = 1; i < walk.size(); ++i) {
      ++counts.try_emplace(walk[i].frame - walk[i - 1].frame, Count{0, counts.size()}).first->second.of;
    }
  }
  const auto is_rarer = [](const auto& a, const auto& b) {
    return a.second.of < b.second.of || (a.second.of == b.second.of && a.second.first > b.second.first);
  };
  const auto usual = std::max_element(counts.begin(), counts.end(), is_rarer);
  return usual == counts.end() ? 0 : usual->first;
}

/// Frames are those of the video, of which few are annotated.
Recording readObsmat(RecordingText& text) {
  text.forEachLine([&](std::string_view line) {
    LineWords words = splitAt(line, BLANKS, true);
    if (words.size() != OBSMAT_COLUMNS) words.clear();
    text.add(words, OBSMAT, 1.0, line);
  });
  Recording recording{text.collect("person", "frame"), std::nullopt};
  std::vector<std::uint64_t> frames;
  for (const auto& [person, walk] : recording.walks) {
    for (const Recording::Sample& sample : walk) frames.push_back(sample.frame);
  }
  std::sort(frames.begin(), frames.end());
  std::uint64_t step = 0;  // of which all frames are multiples, counted from the first one
  for (const std::uint64_t frame : frames) step = std::gcd(step, frame - frames.front());
  step = std::max<std::uint64_t>(1, step);
  const std::uint64_t usual = usualStep(recording);
  recording.frame_duration =
      OBSMAT_PERIOD / (static_cast<double>(usual == 0 ? step : usual) / static_cast<double>(step));
  for (auto& [person, walk] : recording.walks) {
    for (Recording::Sample& sample : walk) sample.frame = (sample.frame - frames.front()) / step;
  }
  return recording;
}

}  // namespace

Recording readRecording(const std::string& file, std::optional<std::uint64_t> instance) {
  const std::string content = readFile(file, FileLimits::RECORDING);
  RecordingText text(file, content);
  std::string_view first;
  text.forEachLine([&](std::string_view line) {
    if (first.empty()) first = line;
  });
  if (first.substr(0, CSV_HEADER.find(',')) == CSV_HEADER.substr(0, CSV_HEADER.find(','))) {
    return readCsv(text, content, instance);
  }
  if (instance.value_or(0) != 0)
    throw InputError(file + ": has no instance " + std::to_string(*instance) + ", expected 0");
  const std::size_t columns = splitAt(first, BLANKS, true).size();
  if (!first.empty() && (first.front() == '#' || columns == 4 || columns == 5)) return readJuPedSim(text);
  if (columns == OBSMAT_COLUMNS) return readObsmat(text);
  throw InputError(
      file + ": is not a recording; expected the header " + std::string(CSV_HEADER) +
      ", the text format of JuPedSim (comments with #, then id frame x y z), or the 8 columns of obsmat.txt");
}

}  // namespace crowd
