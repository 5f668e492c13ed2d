#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "common/text/quotes.h"
#include "common/text/yaml_reader.h"

namespace crowd {
namespace {

/// Detects a document that begins at the same position as the previous one.
class ProgressWatch : public YAML::EventHandler {
 public:
  bool isStuck() const { return is_stuck_; }
  const YAML::Mark& mark() const { return mark_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    is_stuck_ = mark.pos == mark_.pos;
    mark_ = mark;
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
  void OnAlias(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
  void OnScalar(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                const std::string& /*value*/) override {}
  void OnSequenceStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                       YAML::EmitterStyle::value /*style*/) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                  YAML::EmitterStyle::value /*style*/) override {}
  void OnMapEnd() override {}

 private:
  bool is_stuck_ = false;
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

/// Refuses documents that begin with a comma: yaml-cpp treats them as empty and never advances, so that LoadAll would
/// exhaust the memory. This check takes as long as reading, and is skipped if no document can begin with a comma.
void refuseEndlessText(const std::string& text, const std::string& name) {
  if (beginsPlainly(text)) {
    return;
  }
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  ProgressWatch watch;
  while (parser.HandleNextDocument(watch)) {
    if (watch.isStuck()) {
      throwProblem({name, 0, ""}, watch.mark(), "this is not YAML: a comma out of place");
    }
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
