#pragma once

#include <ros/console.h>
#include <ros/serialization.h>

#include <cstdint>
#include <iterator>
#include <vector>

#include "fuzz/fuzz.h"

/// Messages from the bytes of an input.
namespace crowd::fuzz {

/// @brief Reads messages one after the other. roscpp resizes a list before it knows whether the message has its
/// elements; that is not a finding of this package, so lists are checked here.
class MessageStream : public ros::serialization::Stream {
 public:
  static constexpr auto stream_type = ros::serialization::stream_types::Input;

  MessageStream(const std::uint8_t* data, std::size_t size)
      : Stream(const_cast<std::uint8_t*>(data), static_cast<std::uint32_t>(size)) {}  // NOLINT(*-const-cast)

  template <typename Value>
  void next(Value& value) {
    ros::serialization::deserialize(*this, value);
  }
  template <typename Element>
  void next(std::vector<Element>& list) {
    std::uint32_t count = 0;
    next(count);
    if (count > getLength()) ros::serialization::throwStreamOverrun();
    list.resize(count);
    for (Element& element : list) next(element);
  }
  template <typename Message>
  Message take() {
    Message message;
    next(message);
    return message;
  }
  /// @brief Reads a message of tick_messages.h, which has a serialiser of its own.
  template <typename Message>
  Message takeTickMessage() {
    ros::serialization::IStream rest(getData(), getLength());
    Message message;
    ros::serialization::deserialize(rest, message);
    advance(getLength() - rest.getLength());
    return message;
  }
  /// @brief The next byte, or 0.
  std::uint8_t nextByte() {
    std::uint8_t byte = 0;
    if (getLength() > 0) next(byte);
    return byte;
  }
};

/// @brief Calls a handler for one message after the other, as a node that logs errors and goes on.
/// @param handlers read a message from the stream and change `nodes`; the byte before each message chooses one
template <typename Handlers, typename Nodes>
void handleAll(const Handlers& handlers, Nodes& nodes, MessageStream& stream) {
  ros::console::set_logger_level(ROSCONSOLE_DEFAULT_NAME, ros::console::levels::Fatal);
  while (stream.getLength() > 0) {
    try {
      handlers[stream.nextByte() % std::size(handlers)](nodes, stream);
    } catch (const Error&) {
    } catch (const ros::serialization::StreamOverrunException&) {
      return;
    }
  }
}

}  // namespace crowd::fuzz
