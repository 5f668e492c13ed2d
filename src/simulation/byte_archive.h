#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "geometry/geometry.h"
#include "social_crowd/errors.h"

namespace crowd {

/// @brief Writes numbers into a message, bit for bit, for ranks of the same machine type.
class ByteWriter {
 public:
  explicit ByteWriter(std::vector<char>& bytes) : bytes_(bytes) {}

  template <typename Value, typename = std::enable_if_t<std::is_arithmetic_v<Value> || std::is_enum_v<Value>>>
  void operator()(const Value& value) {
    const std::size_t end = bytes_.size();
    bytes_.resize(end + sizeof(Value));
    std::memcpy(bytes_.data() + end, &value, sizeof(Value));
  }
  void operator()(const Vector2& point) {
    (*this)(point.x());
    (*this)(point.y());
  }
  void operator()(const std::vector<Vector2>& points) {
    (*this)(static_cast<std::uint64_t>(points.size()));
    for (const Vector2& point : points) (*this)(point);
  }
  void operator()(const std::string& text) {
    (*this)(static_cast<std::uint64_t>(text.size()));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }

 private:
  std::vector<char>& bytes_;
};

/// @brief Reads what ByteWriter has written, in the same order.
class ByteReader {
 public:
  explicit ByteReader(const std::vector<char>& bytes) : bytes_(bytes) {}

  bool isAtEnd() const { return next_ == bytes_.size(); }

  template <typename Value, typename = std::enable_if_t<std::is_arithmetic_v<Value> || std::is_enum_v<Value>>>
  void operator()(Value& value) {
    if (bytes_.size() - next_ < sizeof(Value)) throw Error("a message between ranks is too short");
    std::memcpy(&value, bytes_.data() + next_, sizeof(Value));
    next_ += sizeof(Value);
  }
  void operator()(Vector2& point) {
    (*this)(point.x());
    (*this)(point.y());
  }
  void operator()(std::vector<Vector2>& points) {
    std::uint64_t count = 0;
    (*this)(count);
    points.clear();
    for (; count > 0; --count) (*this)(points.emplace_back());
  }
  void operator()(std::string& text) {
    std::uint64_t size = 0;
    (*this)(size);
    if (bytes_.size() - next_ < size) throw Error("a message between ranks is too short");
    text.assign(bytes_.data() + next_, size);
    next_ += size;
  }

 private:
  const std::vector<char>& bytes_;
  std::size_t next_ = 0;
};

/// @brief Writes the number of items, then each item by transfer(item).
template <typename Item, typename Transfer>
void transferAll(ByteWriter& write, const std::vector<Item>& items, const Transfer& transfer) {
  write(static_cast<std::uint64_t>(items.size()));
  for (const Item& item : items) transfer(item);
}

/// @brief Reads what the other one has written.
template <typename Item, typename Transfer>
void transferAll(ByteReader& read, std::vector<Item>& items, const Transfer& transfer) {
  std::uint64_t count = 0;
  read(count);
  items.clear();
  for (; count > 0; --count) transfer(items.emplace_back());
}

}  // namespace crowd
