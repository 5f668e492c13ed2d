#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include <cstddef>

namespace crowd::bench {

/// @brief A message of any type; only its size is read [bytes].
struct AnyMessage {
  std::size_t size = 0;
};

}  // namespace crowd::bench

// Message traits for roscpp.
namespace ros {

namespace message_traits {

template <>
struct MD5Sum<crowd::bench::AnyMessage> {
  static const char* value() { return "*"; }
  static const char* value(const crowd::bench::AnyMessage& /*message*/) { return value(); }
};

template <>
struct DataType<crowd::bench::AnyMessage> {
  static const char* value() { return "*"; }
  static const char* value(const crowd::bench::AnyMessage& /*message*/) { return value(); }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<crowd::bench::AnyMessage> {
  template <typename Stream>
  static void read(Stream& stream, crowd::bench::AnyMessage& message) {
    message.size = stream.getLength();
  }
};

}  // namespace serialization

}  // namespace ros
