#include "simulation/agent_results.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "simulation/agent_transfer.h"
#include "simulation/byte_archive.h"

namespace crowd {
namespace {

std::vector<char> bytesOf(const AgentResult& result) {
  std::vector<char> bytes;
  ByteWriter write(bytes);
  transferResult(write, result);
  return bytes;
}

/// All results take as many bytes.
std::size_t recordSize() {
  static const std::size_t SIZE = bytesOf(AgentResult()).size();
  return SIZE;
}

}  // namespace

AgentResult AgentResults::operator[](std::size_t agent) const {
  if (const AgentResult* const held = held_.find(static_cast<AgentId>(agent))) return *held;
  std::vector<char> bytes(recordSize());
  file_->read(agent * bytes.size(), bytes);
  AgentResult result;
  ByteReader read(bytes);
  transferResult(read, result);
  return result;
}

AgentResult AgentResults::at(std::size_t agent) const {
  if (agent >= size_) throw std::out_of_range("there is no agent " + std::to_string(agent));
  return (*this)[agent];
}

AgentResult& AgentResults::add(AgentId agent) {
  size_ = std::max<std::size_t>(size_, agent + 1);
  return held_.add(agent);
}

void AgentResults::storeIfMany() {
  if (held_.size() < MANY) return;
  if (file_ == nullptr) file_ = std::make_shared<ScratchFile>();
  for (std::size_t i = 0; i < held_.size(); ++i) file_->write(held_.idAt(i) * recordSize(), bytesOf(held_.nth(i)));
  held_.clear();
}

}  // namespace crowd
