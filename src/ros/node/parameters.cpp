#include "ros/node/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "common/stop_request.h"
#include "common/text/numbers.h"
#include "common/text/quotes.h"
#include "common/text/suggestions.h"
#include "common/text/yaml_reader.h"
#include "common/thread_pool.h"

namespace crowd {
namespace {

using XmlRpc::XmlRpcValue;

/// Returns a value as YAML.
std::string textOf(XmlRpcValue& value) {
  if (value.getType() == XmlRpcValue::TypeString) return inQuotes(static_cast<std::string&>(value));
  if (value.getType() == XmlRpcValue::TypeBoolean) return static_cast<bool&>(value) ? "true" : "false";
  if (value.getType() == XmlRpcValue::TypeDouble) return toText(static_cast<double&>(value));
  std::string text;
  if (value.getType() == XmlRpcValue::TypeArray) {
    for (int i = 0; i < value.size(); ++i) text += (i > 0 ? ", " : "") + textOf(value[i]);
    return "[" + text + "]";
  }
  if (value.getType() == XmlRpcValue::TypeStruct) {
    for (auto& [key, entry] : value) text += (text.empty() ? "" : ", ") + key + ": " + textOf(entry);
    return "{" + text + "}";
  }
  std::ostringstream stream;
  value.write(stream);
  return stream.str();
}

using Wholes = std::vector<std::int64_t>;

/// Returns the elements of a list of whole numbers of at least 0; nullopt if it is no such list.
std::optional<Wholes> readWholes(XmlRpcValue& list) {
  if (list.getType() != XmlRpcValue::TypeArray) return std::nullopt;
  Wholes numbers;
  // XmlRpcValue::begin() is for structs only.
  for (int i = 0; i < list.size(); ++i) {  // NOLINT(modernize-loop-convert)
    const bool fine = list[i].getType() == XmlRpcValue::TypeInt && static_cast<int&>(list[i]) >= 0;
    if (!fine) return std::nullopt;
    numbers.push_back(static_cast<int&>(list[i]));
  }
  return numbers;
}

/// Returns the same for a text: roscpp sets a list on the command line (`_agents:="[1, 2]"`) as a text.
std::optional<Wholes> parseWholes(const std::string& name, const std::string& text) {
  try {
    const std::vector<YAML::Node> documents = parseYamlStream(text, name);
    if (documents.size() != 1 || !documents.front().IsSequence()) return std::nullopt;
    Wholes numbers;
    for (const YAML::Node& element : documents.front()) {
      numbers.push_back(readWhole(element, {name, 0, ""}, 0, std::numeric_limits<int>::max()));
    }
    return numbers;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Whether a value is an empty text, which a launch file sets for an empty argument.
bool isEmptyText(XmlRpcValue& value) {
  return value.getType() == XmlRpcValue::TypeString && static_cast<std::string&>(value).empty();
}

/// Calls a function of the master that has the name of a parameter, and waits for the master if it is away.
XmlRpcValue askMaster(const std::string& function, const std::string& name) {
  XmlRpcValue request;
  XmlRpcValue response;
  XmlRpcValue answer;
  request[0] = ros::this_node::getName();
  request[1] = name;
  const bool is_answered = ros::master::execute(function, request, response, answer, true);
  if (ros::isShuttingDown()) throw Stopped();
  if (!is_answered) throw Error("the parameters of " + name + " were deleted while they were read");
  return answer;
}

/// Returns all parameters of a namespace, a struct; something else if there are none.
XmlRpcValue readNamespace(const std::string& name) {
  XmlRpcValue exists = askMaster("hasParam", name);
  return static_cast<bool&>(exists) ? askMaster("getParam", name) : XmlRpcValue();
}

}  // namespace

Parameters::Parameters(const ros::NodeHandle& private_node)
    : namespace_(private_node.getNamespace()), values_(readNamespace(namespace_)) {}

XmlRpcValue* Parameters::find(const std::string& name) {
  asked_.insert(name);
  const bool is_set = values_.getType() == XmlRpcValue::TypeStruct && values_.hasMember(name);
  return is_set && !isEmptyText(values_[name]) ? &values_[name] : nullptr;
}

XmlRpcValue* Parameters::find(const std::string& name, const std::string& expected, const std::string& otherwise) {
  descriptions_[name] = expected + (otherwise.empty() ? "" : "; default " + otherwise);
  return find(name);
}

bool Parameters::isSet(const std::string& name) { return find(name) != nullptr; }

void Parameters::complain(const std::string& name, const std::string& what) {
  problems_.push_back("~" + name + ": " + what);
}

void Parameters::complainMissing(const std::string& name, const std::string& what) { missing_[name] = what; }

void Parameters::expect(const std::string& name, const std::string& expected, XmlRpcValue& got) {
  complain(name, "expected " + expected + ", got " + textOf(got));
}

std::string Parameters::text(const std::string& name, const std::string& otherwise, const std::string& expected) {
  XmlRpcValue* const value = find(name, expected, otherwise);
  if (value == nullptr) return otherwise;
  if (value->getType() == XmlRpcValue::TypeString) return *value;
  // roslaunch converts a text that looks like a number.
  if (value->getType() == XmlRpcValue::TypeInt) return std::to_string(static_cast<int>(*value));
  if (value->getType() == XmlRpcValue::TypeDouble) return toText(static_cast<double>(*value));
  expect(name, expected, *value);
  return otherwise;
}

bool Parameters::flag(const std::string& name, bool otherwise) {
  const std::string expected = "true or false";
  XmlRpcValue* const value = find(name, expected, otherwise ? "true" : "false");
  if (value == nullptr) return otherwise;
  if (value->getType() == XmlRpcValue::TypeBoolean) return *value;
  expect(name, expected, *value);
  return otherwise;
}

double Parameters::number(const std::string& name, double otherwise, const NumberRange& range,
                          const std::string& alternative) {
  XmlRpcValue* const value = find(name, toText(range), toText(otherwise));
  if (value == nullptr) return otherwise;
  double number = std::nan("");
  if (value->getType() == XmlRpcValue::TypeDouble) number = static_cast<double>(*value);
  if (value->getType() == XmlRpcValue::TypeInt) number = static_cast<int>(*value);
  if (range.contains(number)) return number;
  expect(name, toText(range) + alternative, *value);
  return otherwise;
}

std::int64_t Parameters::whole(const std::string& name, std::int64_t otherwise, std::int64_t low, std::int64_t high) {
  const std::string expected = "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
  XmlRpcValue* const value = find(name, expected, std::to_string(otherwise));
  if (value == nullptr) return otherwise;
  if (value->getType() == XmlRpcValue::TypeInt) {
    const std::int64_t number = static_cast<int>(*value);
    if (number >= low && number <= high) return number;
  }
  expect(name, expected, *value);
  return otherwise;
}

std::vector<std::int64_t> Parameters::wholes(const std::string& name) {
  const std::string expected = "a list of whole numbers of at least 0, such as [0, 1, 2]";
  XmlRpcValue* const value = find(name, expected, "[]");
  if (value == nullptr) return {};
  const bool is_text = value->getType() == XmlRpcValue::TypeString;
  const auto numbers = is_text ? parseWholes(name, static_cast<std::string&>(*value)) : readWholes(*value);
  if (!numbers) expect(name, expected, *value);
  return numbers.value_or(Wholes());
}

std::optional<std::string> Parameters::map(const std::string& name) {
  XmlRpcValue* const value = find(name);
  if (value == nullptr) return std::nullopt;
  if (value->getType() == XmlRpcValue::TypeStruct) return textOf(*value);
  if (value->getType() != XmlRpcValue::TypeString) return std::nullopt;
  const std::string& text = static_cast<std::string&>(*value);
  const std::size_t begin = text.find_first_not_of(" \n");
  if (begin == std::string::npos || text[begin] != '{') return std::nullopt;
  return text;
}

std::set<std::string> Parameters::findUnknown() {
  std::set<std::string> unknown;
  if (values_.getType() != XmlRpcValue::TypeStruct) return unknown;
  for (const auto& [name, value] : values_) {
    if (asked_.count(name) == 0) unknown.insert(name);
  }
  return unknown;
}

void Parameters::noteUnknown() {
  const std::vector<std::string> known(asked_.begin(), asked_.end());
  const auto problem = [&](const std::string& name) {
    const std::string hint = didYouMean(name, known, "~");
    return "there is no such parameter" + (hint.empty() ? "; there are " : hint + " There are ") +
           joinNames(known, "~") + ". It may be left from an earlier start: rosparam delete " + namespace_ + "/" + name;
  };
  for (const std::string& name : findUnknown()) {
    complain(name, problem(name));
    missing_.erase(nearestName(name, known));
  }
}

void Parameters::finish() {
  for (const auto& [name, description] : descriptions_)
    ROS_DEBUG("parameter ~%s: %s", name.c_str(), description.c_str());
  noteUnknown();
  for (const auto& [name, what] : missing_) complain(name, what);
  if (problems_.empty()) return;
  std::string text = "bad parameters of " + namespace_ + ":";
  for (const std::string& problem : problems_) text += "\n  " + problem;
  throw InputError(text);
}

unsigned readThreads(Parameters& parameters) {
  constexpr std::int64_t MOST = 1024;
  return ThreadPool::countFor(static_cast<unsigned>(parameters.whole("threads", 0, 0, MOST)));
}

}  // namespace crowd
