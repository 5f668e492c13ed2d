"""The part of rosbridge's protocol (JSON) that clients such as roslib use to listen to topics and to call services."""
import time

import genpy
import rospy
from crowd_drawing.errors import InputError
from crowd_web.client import as_json
from crowd_web.message_json import fill, to_json
from crowd_web.page_commands import message_of, number, whole
from rosgraph.names import is_legal_name

MOST_SUBSCRIPTIONS = 256
MOST_WAITING = 100  # messages of a subscription for a slow client
NAME_LENGTH = 200


class Subscription:
    """What a client wants of a topic."""

    def __init__(self, session, topic, throttle_rate, queue_length):
        self.session, self.topic = session, topic
        self.period = throttle_rate / 1000  # [s] between two messages
        self.depth = max(1, min(queue_length, MOST_WAITING))
        self.next_at = 0.0
        self.handle = session.graph.listen(topic, self.take)

    def take(self, data, kind):
        now = time.monotonic()
        if now < self.next_at:
            return
        self.next_at = now + self.period
        try:
            message = self.session.graph.message_class(kind)()
            message.deserialize(data)
        except (InputError, genpy.DeserializationError) as error:
            self.session.say('error', f'{self.topic}: {error}')
            return
        text = as_json({'op': 'publish', 'topic': self.topic, 'msg': to_json(message, kind)})
        self.session.client.send_latest(('topic', self.topic), text, self.depth)


class RosbridgeSession:
    """A client at /rosbridge."""

    def __init__(self, client, graph):
        self.client, self.graph = client, graph
        self.subscriptions = {}  # by topic, then by id
        self.operations = {'subscribe': self.subscribe, 'unsubscribe': self.unsubscribe,
                           'call_service': self.call_service, 'set_level': self.ignore, 'status': self.ignore}

    async def begin(self):
        await self.graph.refresh()
        self.graph.watch(self, lambda: None)  # so that topics and services are known

    def end(self):
        self.graph.unwatch(self)
        for by_id in self.subscriptions.values():
            for subscription in by_id.values():
                self.graph.stop_listening(subscription.handle)
        self.subscriptions = {}

    def say(self, level, text, identity=None):
        self.client.send({'op': 'status', 'level': level, 'msg': text,
                          **({} if identity is None else {'id': identity})})

    def refuse(self, problem):
        self.say('error', problem)

    async def take(self, data):
        """Takes a message. Raises NotTheProtocol."""
        message, operation = message_of(data, 'op')
        identity = message.get('id') if isinstance(message.get('id'), (str, int)) else None
        try:
            if operation not in self.operations:
                raise InputError(f"'{operation[:NAME_LENGTH]}' is not served; expected subscribe, unsubscribe or "
                                 'call_service')
            await self.operations[operation](message, identity)
        except InputError as error:
            self.say('error', str(error), identity)

    async def ignore(self, message, identity):
        pass

    async def subscribe(self, message, identity):
        topic = name_in(message, 'topic')
        if message.get('compression', 'none') != 'none':
            raise InputError('compression: expected none')
        if sum(map(len, self.subscriptions.values())) >= MOST_SUBSCRIPTIONS:
            raise InputError(f'there are {MOST_SUBSCRIPTIONS} subscriptions already')
        kind = self.graph.topics.get(rospy.resolve_name(topic))
        if kind and message.get('type') not in (None, kind):
            raise InputError(f"{topic}: has the type {kind}")
        rate = read(message, 'throttle_rate', number(0, 1e9), 0)
        length = read(message, 'queue_length', whole(0), 0)
        by_id = self.subscriptions.setdefault(topic, {})
        if identity in by_id:
            self.graph.stop_listening(by_id.pop(identity).handle)
        by_id[identity] = Subscription(self, topic, rate, length)

    async def unsubscribe(self, message, identity):
        topic = name_in(message, 'topic')
        by_id = self.subscriptions.get(topic, {})
        gone = [identity] if identity in by_id else list(by_id) if identity is None else []
        for key in gone:
            self.graph.stop_listening(by_id.pop(key).handle)
        if not by_id:
            self.subscriptions.pop(topic, None)
            self.client.forget(('topic', topic))

    async def call_service(self, message, identity):
        name = name_in(message, 'service')
        answer = {'op': 'service_response', 'service': name, **({} if identity is None else {'id': identity})}
        try:
            values = await self.values_of(name, message.get('args', {}))
        except InputError as error:
            self.client.send(dict(answer, values=str(error), result=False))
        else:
            self.client.send(dict(answer, values=values, result=True))

    async def values_of(self, name, arguments):
        """Returns the response of a service as JSON. Raises InputError."""
        name = rospy.resolve_name(name)
        if name.startswith('/rosapi/'):
            return self.graph_values(name, arguments)
        if name not in self.graph.services:
            await self.graph.refresh()
        request = fill(self.graph.service_class(name)._request_class(), arguments)
        response = await self.graph.call(name, request)
        return to_json(response, response._type)

    def graph_values(self, name, arguments):
        """Answers the calls with which clients list topics and services. Raises InputError."""
        topics, services = self.graph.topics, self.graph.services
        if name == '/rosapi/topics':
            return {'topics': list(topics), 'types': list(topics.values())}
        if name == '/rosapi/services':
            return {'services': list(services)}
        of = arguments if isinstance(arguments, dict) else {}
        if name == '/rosapi/topic_type':
            return {'type': topics.get(str(of.get('topic')), '')}
        if name == '/rosapi/service_type':
            return {'type': services.get(str(of.get('service')), '')}
        raise InputError(f"'{name}' is not served; expected topics, services, topic_type or service_type")


def name_in(message, key):
    """Returns a name of ROS under a key. Raises InputError."""
    value = message.get(key)
    if not isinstance(value, str) or not 0 < len(value) <= NAME_LENGTH or not is_legal_name(value):
        raise InputError(f'{key}: expected a name')
    return value


def read(message, key, reader, default):
    """Returns a number under a key. Raises InputError."""
    try:
        return reader(message[key]) if message.get(key) is not None else default
    except (ValueError, OverflowError) as error:
        raise InputError(f'{key}: expected {error}') from None
