"""The protocol of Foxglove (foxglove.websocket.v1): topics of ROS and services of the crowd, as serialised messages."""
import io
import struct

import genpy
import rospy
from crowd_drawing.errors import InputError
from crowd_web.page_commands import NotTheProtocol, message_of

PROTOCOL = 'foxglove.websocket.v1'
MESSAGE, TIME, SERVICE_RESPONSE = 1, 2, 3  # opcodes of binary messages to the client
SERVICE_REQUEST = 2  # and from it
ENCODING, SCHEMA_ENCODING = 'ros1', 'ros1msg'
ERROR = 2  # level of a status
DEPTH = 16  # messages of a subscription that wait for a slow client
MOST_SUBSCRIPTIONS = 256


class Numbers:
    """Gives each (name, type) a number of its own."""

    def __init__(self):
        self.numbers = {}

    def __getitem__(self, entry):
        return self.numbers.setdefault(entry, len(self.numbers) + 1)


CHANNELS, SERVICES = Numbers(), Numbers()  # the same for all clients


class FoxgloveSession:
    """A client at /. Topics are subscribed to only while it subscribes to their channels."""

    def __init__(self, client, graph):
        self.client, self.graph = client, graph
        self.channels, self.services = {}, {}  # as advertised: (name, type) by number
        self.subscriptions = {}  # handles by number of the subscription
        self.clock = None

    async def begin(self):
        await self.graph.refresh()
        has_clock = rospy.get_param('/use_sim_time', False)
        self.client.send({'op': 'serverInfo', 'name': 'social_crowd', 'supportedEncodings': [ENCODING],
                          'capabilities': ['services'] + ['time'] * has_clock, 'metadata': {'ROS_DISTRO': 'noetic'}})
        if has_clock:
            self.clock = self.graph.listen('/clock', lambda data, _: self.client.send_latest(
                'time', struct.pack('<BQ', TIME, nanoseconds_of(data))))
        self.graph.watch(self, self.advertise)
        self.advertise()

    def end(self):
        self.graph.unwatch(self)
        for handle in [*self.subscriptions.values(), *([self.clock] if self.clock else [])]:
            self.graph.stop_listening(handle)
        self.subscriptions, self.clock = {}, None

    def advertise(self):
        """Tells the client which topics and services have come and gone."""
        self.channels = self.tell('', 'channel', self.channels, self.channel_of, {
            CHANNELS[entry]: entry for entry in self.graph.topics.items()})
        self.services = self.tell('Services', 'service', self.services, self.service_of, {
            SERVICES[entry]: entry for entry in self.graph.services.items()})

    def tell(self, what, word, last, describe, present):
        gone = [number for number in last if number not in present]
        come = [description for number, entry in present.items() if number not in last
                for description in describe(number, *entry)]
        if gone:
            self.client.send({'op': 'unadvertise' + what, word + 'Ids': gone})
        if come:
            self.client.send({'op': 'advertise' + what, word + 's': come})
        return present

    def channel_of(self, number, topic, kind):
        try:
            return [{'id': number, 'topic': topic, **schema_of(self.graph.message_class(kind))}]
        except InputError:  # not installed here, so its definition is not known
            return []

    def service_of(self, number, name, kind):
        try:
            of = self.graph.service_class(name)
        except InputError:
            return []
        return [{'id': number, 'name': name, 'type': kind, 'request': schema_of(of._request_class),
                 'response': schema_of(of._response_class), 'requestSchema': of._request_class._full_text,
                 'responseSchema': of._response_class._full_text}]

    def refuse(self, problem):
        self.client.send({'op': 'status', 'level': ERROR, 'message': problem})

    async def take(self, data):
        """Takes a message. Raises NotTheProtocol."""
        if not isinstance(data, str):
            return await self.take_binary(data)
        message, operation = message_of(data, 'op')
        try:
            if operation == 'subscribe':
                self.subscribe(message.get('subscriptions'))
            elif operation == 'unsubscribe':
                self.unsubscribe(message.get('subscriptionIds'))
            else:
                raise InputError(f"'{operation[:100]}' is not served; expected subscribe, unsubscribe or a call")
        except InputError as error:
            self.refuse(str(error))

    def subscribe(self, entries):
        for number, channel in numbers_in(entries, 'subscriptions', 'id', 'channelId'):
            if channel not in self.channels:
                raise InputError(f'there is no channel {channel}')
            if number in self.subscriptions:
                raise InputError(f'there is a subscription {number} already')
            if len(self.subscriptions) >= MOST_SUBSCRIPTIONS:
                raise InputError(f'there are {MOST_SUBSCRIPTIONS} subscriptions already')
            self.subscriptions[number] = self.graph.listen(self.channels[channel][0], self.sender(number, channel))

    def sender(self, number, channel):
        expected = self.channels[channel][1]

        def send(data, kind):
            if kind == expected:
                head = struct.pack('<BIQ', MESSAGE, number, rospy.get_rostime().to_nsec())
                self.client.send_latest(('message', number), head + data, DEPTH)
        return send

    def unsubscribe(self, numbers):
        for number, in numbers_in([{'id': number} for number in numbers] if isinstance(numbers, list) else None,
                                  'subscriptionIds', 'id'):
            if number not in self.subscriptions:
                raise InputError(f'there is no subscription {number}')
            self.graph.stop_listening(self.subscriptions.pop(number))
            self.client.forget(('message', number))

    async def take_binary(self, data):
        try:
            operation, service, call, length = struct.unpack_from('<BIII', data)
        except struct.error:
            raise NotTheProtocol('expected a service call') from None
        if operation != SERVICE_REQUEST or len(data) < 13 + length:
            raise NotTheProtocol(f'expected a service call (operation {SERVICE_REQUEST})')
        try:
            response = await self.call(service, data[13:13 + length], data[13 + length:])
        except InputError as error:
            self.client.send({'op': 'serviceCallFailure', 'serviceId': service, 'callId': call, 'message': str(error)})
            return
        head = struct.pack('<BIII', SERVICE_RESPONSE, service, call, len(ENCODING))
        self.client.send_data(head + ENCODING.encode() + response)

    async def call(self, number, encoding, data):
        """Calls a service with a serialised request. Returns the serialised response. Raises InputError."""
        if number not in self.services:
            raise InputError(f'there is no service {number}')
        if encoding != ENCODING.encode():
            raise InputError(f'expected the encoding {ENCODING}')
        name = self.services[number][0]
        request = self.graph.service_class(name)._request_class()
        try:
            request.deserialize(data)
        except (genpy.DeserializationError, struct.error, ValueError) as error:
            raise InputError(f'the request does not fit {request._type}: {error}') from None
        stream = io.BytesIO()
        (await self.graph.call(name, request)).serialize(stream)
        return stream.getvalue()


def schema_of(kind):
    """Returns how messages of a class are encoded."""
    return {'encoding': ENCODING, 'schemaName': kind._type, 'schemaEncoding': SCHEMA_ENCODING,
            'schema': kind._full_text}


def nanoseconds_of(clock):
    """Returns the time in a serialised rosgraph_msgs/Clock."""
    seconds, rest = struct.unpack_from('<II', clock)
    return seconds * 10**9 + rest


def numbers_in(entries, where, *keys):
    """Yields the numbers under keys of each entry of a list. Raises InputError."""
    if not isinstance(entries, list):
        raise InputError(f'{where}: expected a list')
    for entry in entries:
        found = [entry.get(key) if isinstance(entry, dict) else None for key in keys]
        if not all(type(number) is int and 0 <= number < 2**32 for number in found):
            raise InputError(f"{where}: expected whole numbers under {' and '.join(keys)}")
        yield found
