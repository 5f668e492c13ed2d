#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

#include "common/text/quotes.h"
#include "common/text/yaml_reader.h"

namespace crowd {
namespace {

/// The elements that a text may have beyond one for each of its bytes, which only aliases can give. Our choice: no
/// scenario of the package needs any.
constexpr std::size_t MOST_REPEATED = 100'000;

/// Watches a text before it is loaded. Refuses a document that begins at the same position as the previous one, an
/// alias within what it stands for, and aliases that would make much of a small text.
class TextWatch : public YAML::EventHandler {
 public:
  TextWatch(const std::string& text, const std::string& name) : most_(text.size() + MOST_REPEATED), name_(name) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (mark.pos == mark_.pos) fail(mark, "this is not YAML: a comma out of place");
    mark_ = mark;
    sizes_.clear();
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { addLeaf(mark, anchor); }
  void OnScalar(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                const std::string& /*value*/) override {
    addLeaf(mark, anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto size = sizes_.find(anchor);
    if (size == sizes_.end()) fail(mark, "an alias within what it stands for");
    add(mark, size->second);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    open(mark, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    open(mark, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    YAML::anchor_t anchor;
    std::size_t before;  // number of elements
  };

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& problem) const {
    throwProblem({name_, 0, ""}, mark, problem);
  }
  void add(const YAML::Mark& mark, std::size_t count) {
    count_ += count;
    if (count_ <= most_) return;
    fail(mark, "too many aliases: expected at most " + std::to_string(most_) + " elements in place of them");
  }
  void addLeaf(const YAML::Mark& mark, YAML::anchor_t anchor) {
    add(mark, 1);
    if (anchor != YAML::NullAnchor) sizes_[anchor] = 1;
  }
  void open(const YAML::Mark& mark, YAML::anchor_t anchor) {
    open_.push_back({anchor, count_});
    add(mark, 1);
  }
  void close() {
    const auto& [anchor, before] = open_.back();
    if (anchor != YAML::NullAnchor) sizes_[anchor] = count_ - before;
    open_.pop_back();
  }

  std::size_t most_;  // number of elements
  const std::string& name_;
  std::size_t count_ = 0;                        // of elements, aliases in full
  std::map<YAML::anchor_t, std::size_t> sizes_;  // of what anchors of the document stand for
  std::vector<Open> open_;
  YAML::Mark mark_ = YAML::Mark::null_mark();
};

/// Whether every line begins like a line of a block map or list: with a word, "- ", a comment or "---" alone.
bool beginsPlainly(const std::string& text) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::size_t first = std::min(text.find_first_not_of(" \r", begin), end);
    const char head = first < end ? text[first] : '#';
    const bool word = std::isalnum(static_cast<unsigned char>(head)) != 0 || head == '#';
    const bool entry = head == '-' && first + 1 < end && text[first + 1] == ' ';
    if (!word && !entry && text.compare(begin, end - begin, "---") != 0) {
      return false;
    }
    begin = end + 1;
  }
  return true;
}

/// Refuses texts that would exhaust the memory: aliases may repeat aliases, and yaml-cpp treats documents that begin
/// with a comma as empty and never advances. This check takes as long as reading, and is skipped if there can be
/// neither.
void refuseEndlessText(const std::string& text, const std::string& name) {
  if (beginsPlainly(text) && text.find('*') == std::string::npos) {
    return;
  }
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  TextWatch watch(text, name);
  while (parser.HandleNextDocument(watch)) {
  }
}

}  // namespace

std::vector<YAML::Node> loadYamlStream(const std::string& file, FileKinds kinds) {
  return parseYamlStream(readFile(file, FileLimits::YAML, kinds), file);
}

std::vector<YAML::Node> parseYamlStream(const std::string& text, const std::string& name) {
  try {
    refuseEndlessText(text, name);
    return YAML::LoadAll(text);
  } catch (const YAML::Exception& error) {
    // Some messages of yaml-cpp contain words of the text.
    const std::string cause = HiddenQuotes::areActive() ? "" : ": " + shortened(error.msg);
    throwProblem({name, 0, ""}, error.mark, "this is not YAML" + cause);
  }
}

}  // namespace crowd
