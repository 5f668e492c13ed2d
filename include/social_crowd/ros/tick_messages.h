#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <social_crowd/Perceptions.h>
#include <social_crowd/RelativeActions.h>

#include <cstdint>
#include <memory>
#include <string>

#include "social_crowd/world/perception.h"
#include "social_crowd/world/relative_action.h"

/// The two messages of every tick as the nodes hold them: the core's own types, which are written to the wire and read
/// from it without a step in between. On the wire, and to everybody else, they are social_crowd/Perceptions and
/// social_crowd/RelativeActions. Within a process they are passed on by pointer and never written at all.
namespace crowd {

/// @brief What every agent perceives at the start of a tick; on the wire social_crowd/Perceptions.
struct PerceptionsMessage {
  using Wire = social_crowd::Perceptions;
  using Ptr = boost::shared_ptr<PerceptionsMessage>;
  using ConstPtr = boost::shared_ptr<const PerceptionsMessage>;

  std_msgs::Header header;
  std::uint64_t run = 0;                      ///< of the controller that tells this
  Vision vision;                              ///< with which the perceptions were made
  std::shared_ptr<const Perceptions> shared;  ///< what is sent: the episode's own
  Perceptions received;                       ///< what came over the wire; counts where nothing is shared

  const Perceptions& content() const { return shared != nullptr ? *shared : received; }
};

/// @brief A learner's answer; on the wire social_crowd/RelativeActions. Whether the actions are valid is judged by who
/// takes them.
struct ActionsMessage {
  using Wire = social_crowd::RelativeActions;
  using Ptr = boost::shared_ptr<ActionsMessage>;
  using ConstPtr = boost::shared_ptr<const ActionsMessage>;

  std_msgs::Header header;
  std::uint64_t run = 0;  ///< of the perceptions answered
  std::string node;       ///< name of the learner; may be empty
  RelativeActions content;
};

/// @brief Numbers of agents from here on are taken for damaged messages.
constexpr AgentId AGENT_LIMIT = 10'000'000;

/// @brief To be asked before what came in a message is used.
/// @throws InputError if it contradicts itself: parts beyond the lists, numbers that are not finite.
void requireValid(const Perceptions& perceptions);

}  // namespace crowd

namespace ros {

namespace message_traits {

/// Tells of a message what is told of another one.
template <template <typename> class Trait, typename Message, typename Wire>
struct TraitOf {
  static const char* value() { return Trait<Wire>::value(); }
  static const char* value(const Message& /*message*/) { return value(); }
};

template <>
struct IsMessage<crowd::PerceptionsMessage> : TrueType {};
template <>
struct HasHeader<crowd::PerceptionsMessage> : TrueType {};
template <>
struct MD5Sum<crowd::PerceptionsMessage> : TraitOf<MD5Sum, crowd::PerceptionsMessage, crowd::PerceptionsMessage::Wire> {
};
template <>
struct DataType<crowd::PerceptionsMessage>
    : TraitOf<DataType, crowd::PerceptionsMessage, crowd::PerceptionsMessage::Wire> {};
template <>
struct Definition<crowd::PerceptionsMessage>
    : TraitOf<Definition, crowd::PerceptionsMessage, crowd::PerceptionsMessage::Wire> {};

template <>
struct IsMessage<crowd::ActionsMessage> : TrueType {};
template <>
struct HasHeader<crowd::ActionsMessage> : TrueType {};
template <>
struct MD5Sum<crowd::ActionsMessage> : TraitOf<MD5Sum, crowd::ActionsMessage, crowd::ActionsMessage::Wire> {};
template <>
struct DataType<crowd::ActionsMessage> : TraitOf<DataType, crowd::ActionsMessage, crowd::ActionsMessage::Wire> {};
template <>
struct Definition<crowd::ActionsMessage> : TraitOf<Definition, crowd::ActionsMessage, crowd::ActionsMessage::Wire> {};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<crowd::PerceptionsMessage> {
  static void write(OStream& stream, const crowd::PerceptionsMessage& message);
  /// @throws StreamOverrunException if the message is shorter than it says.
  static void read(IStream& stream, crowd::PerceptionsMessage& message);
  static std::uint32_t serializedLength(const crowd::PerceptionsMessage& message);
};

template <>
struct Serializer<crowd::ActionsMessage> {
  static void write(OStream& stream, const crowd::ActionsMessage& message);
  /// @throws StreamOverrunException if the message is shorter than it says.
  static void read(IStream& stream, crowd::ActionsMessage& message);
  static std::uint32_t serializedLength(const crowd::ActionsMessage& message);
};

}  // namespace serialization

}  // namespace ros
