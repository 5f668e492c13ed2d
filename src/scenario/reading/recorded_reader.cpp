#include "scenario/reading/recorded_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "common/text/numbers.h"
#include "geometry/limits.h"
#include "scenario/reading/list_reader.h"
#include "scenario/reading/recording_file.h"

namespace crowd {
namespace {

constexpr NumberLimit PART_TIME{NumberRule::NOT_NEGATIVE, limits::DURATION, "s"};
constexpr NumberLimit PART_OFFSET{NumberRule::ANY, limits::DURATION, "s"};

RecordedPeople readDescription(const YamlMap& map) {
  RecordedPeople read;
  const std::filesystem::path folder = std::filesystem::path(map.place().file).parent_path();
  read.file = (folder / map.text("file")).string();
  if (map.has("instance")) read.instance = map.count("instance");
  if (map.has("frame_rate")) read.frame_rate = map.number("frame_rate", limits::FRAME_RATE);
  read.from = map.number("from", PART_TIME, read.from);
  if (map.has("to")) read.to = map.number("to", PART_TIME);
  if (read.to && *read.to <= read.from) {
    throwExpected(map.placeOf("to"), map.need("to"), "a time after from (" + toText(read.from) + " s)");
  }
  read.offset = map.number("offset", PART_OFFSET, read.offset);
  read.people = readList<std::uint64_t>(map.find("people"), map.placeOf("people"), readCount);
  if (map.has("people") && read.people.empty()) {
    throwExpected(map.placeOf("people"), map.need("people"), "the number of at least one person");
  }
  read.radius = map.number("radius", limits::RADIUS, read.radius);
  if (map.has("shift")) read.shift = readVector(map.need("shift"), map.placeOf("shift"), limits::PLACE);
  return read;
}

/// Makes the tracks of an entry. Errors are those of its file.
class RecordedTracks {
 public:
  RecordedTracks(const RecordedPeople& entry, const Recording& recording, double tick_duration)
      : entry_(entry),
        recording_(recording),
        frame_duration_(entry.frame_rate ? 1.0 / *entry.frame_rate : recording.frame_duration.value_or(tick_duration)) {
  }

  /// The part of a person's walk that the entry uses, in the time of the episode; null: none.
  std::shared_ptr<const Track> of(std::uint64_t person) const {
    const Track walk = walkOf(person);
    const double from = std::max(entry_.from, walk.times().front());
    const double to = std::min(entry_.to.value_or(limits::DURATION), walk.times().back());
    if (from > to) return nullptr;
    std::vector<double> times{from};
    std::vector<Vector2> places{walk.at(from).position};
    for (std::size_t i = 0; i < walk.times().size(); ++i) {
      if (walk.times()[i] <= from || walk.times()[i] >= to) continue;
      times.push_back(walk.times()[i]);
      places.push_back(walk.places()[i]);
    }
    if (to > from) {
      times.push_back(to);
      places.push_back(walk.at(to).position);
    }
    for (double& time : times) time = (time - entry_.from) + entry_.offset;
    return std::make_shared<const Track>(checked(person, std::move(times), std::move(places)));
  }

 private:
  Track walkOf(std::uint64_t person) const {
    std::vector<double> times;
    std::vector<Vector2> places;
    for (const Recording::Sample& sample : recording_.walks.at(person)) {
      times.push_back(static_cast<double>(sample.frame) * frame_duration_);
      places.emplace_back(sample.place + entry_.shift);
    }
    return checked(person, std::move(times), std::move(places));
  }

  Track checked(std::uint64_t person, std::vector<double> times, std::vector<Vector2> places) const {
    const auto is_far = [](const Vector2& place) { return place.lpNorm<Eigen::Infinity>() > limits::PLACE.most; };
    if (!(std::abs(times.back()) <= 2.0 * limits::DURATION)) fail(person, "is there later than 1e9 s");
    if (std::any_of(places.begin(), places.end(), is_far)) fail(person, "is farther away than 1e6 m");
    Track track(std::move(times), std::move(places));
    if (track.maxSpeed() <= limits::SPEED.most) return track;
    fail(person, "moves at " + toText(track.maxSpeed()) + " m/s, expected at most 1000 m/s");
  }

  [[noreturn]] void fail(std::uint64_t person, const std::string& problem) const {
    throw InputError(entry_.file + ": person " + std::to_string(person) + " " + problem);
  }

  const RecordedPeople& entry_;
  const Recording& recording_;
  const double frame_duration_;  // [s]
};

std::string partText(const RecordedPeople& entry) {
  return "from " + toText(entry.from) + " s to " + (entry.to ? toText(*entry.to) + " s" : "its end");
}

void requireKnown(const YamlMap& map, const RecordedPeople& entry, const Recording& recording) {
  std::set<std::uint64_t> named;
  for (std::size_t i = 0; i < entry.people.size(); ++i) {
    const YamlPlace place = map.placeOf("people").element(i);
    const YAML::Node node = map.need("people")[i];
    const std::uint64_t person = entry.people[i];
    if (!named.insert(person).second) throwProblem(place, node, std::to_string(person) + " is there twice");
    if (recording.walks.count(person) > 0) continue;
    throwProblem(place, node,
                 "there is no person " + std::to_string(person) + " in " + entry.file + "; the " +
                     std::to_string(recording.walks.size()) + " there have numbers from " +
                     std::to_string(recording.walks.begin()->first) + " to " +
                     std::to_string(recording.walks.rbegin()->first));
  }
}

/// Calls work(); adds where the scenario names the file to errors of its content.
template <typename Work>
auto inFileOf(const YamlMap& map, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throwProblem(map.placeOf("file"), map.need("file"), error.what());
  }
}

std::vector<Obstacle> peopleOf(const RecordedPeople& entry, const Recording& recording, double tick_duration) {
  const RecordedTracks tracks(entry, recording, tick_duration);
  const std::set<std::uint64_t> named(entry.people.begin(), entry.people.end());
  std::vector<Obstacle> people;
  for (const auto& [person, walk] : recording.walks) {
    if (!named.empty() && named.count(person) == 0) continue;
    if (const auto track = tracks.of(person)) {
      people.push_back({ObstaclePath::recorded(track), entry.radius, person});
    } else if (!named.empty()) {
      throw InputError(entry.file + ": person " + std::to_string(person) + " is not there " + partText(entry));
    }
  }
  if (people.empty()) throw InputError(entry.file + ": nobody is there " + partText(entry));
  return people;
}

RecordedGroup readEntry(const YAML::Node& node, const YamlPlace& place, double tick_duration, std::size_t& samples) {
  const YamlMap map(node, place,
                    {"file", "instance", "frame_rate", "from", "to", "offset", "people", "radius", "shift"});
  RecordedGroup group;
  group.line = lineOf(node);
  group.description = readDescription(map);
  const RecordedPeople& entry = group.description;
  const Recording recording = inFileOf(map, [&] { return readRecording(entry.file, entry.instance); });
  requireKnown(map, entry, recording);
  group.people = inFileOf(map, [&] { return peopleOf(entry, recording, tick_duration); });
  for (const Obstacle& person : group.people) samples += person.path.points().size();
  if (samples <= limits::SAMPLES) return group;
  throwProblem(place, node, "expected at most " + std::to_string(limits::SAMPLES) + " positions in all");
}

}  // namespace

std::vector<RecordedGroup> readRecorded(const YamlMap& map, double tick_duration) {
  std::size_t samples = 0;
  const auto read = [&](const YAML::Node& entry, const YamlPlace& place) {
    return readEntry(entry, place, tick_duration, samples);
  };
  return readList<RecordedGroup>(map.find("recorded"), map.placeOf("recorded"), read);
}

}  // namespace crowd
