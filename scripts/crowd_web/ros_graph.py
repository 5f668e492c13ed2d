"""Topics and services of ROS for all protocols: serialised messages, from one subscription to each topic."""
import asyncio
import collections
import concurrent.futures
import http.client
import io
import itertools
import xmlrpc.client

import genpy
import roslib.message
import rosgraph
import rosservice
import rospy
from crowd_drawing.errors import InputError

POLL_PERIOD = 1.0  # [s] between two looks at the graph, while somebody wants to know
DEPTH = 16  # messages of a topic that wait for the event loop; older ones are dropped
BUFFER = 2**22  # [bytes] of a connection; with little ones rospy copies large messages many times
CALLS = 32  # service calls at the same time
NO_MASTER = (OSError, http.client.HTTPException, xmlrpc.client.Error, rosgraph.MasterException)
SERVED_PACKAGES = ('social_crowd', 'std_srvs')  # of the types of services that clients may call


class Topic:
    """A topic that somebody listens to."""

    def __init__(self, graph, name):
        self.graph = graph
        self.listeners = {}  # functions by key
        self.latched = {}  # the last message by publisher
        self.arrived = collections.deque(maxlen=DEPTH)
        self.is_scheduled = False
        self.subscriber = rospy.Subscriber(name, rospy.AnyMsg, self.take, queue_size=DEPTH, buff_size=BUFFER,
                                           tcp_nodelay=True)

    def take(self, message):
        """In the thread of rospy."""
        self.arrived.append(message)
        if not self.is_scheduled:
            self.is_scheduled = True
            try:
                self.graph.loop.call_soon_threadsafe(self.deliver)
            except RuntimeError:  # the loop has ended
                pass

    def deliver(self):
        self.is_scheduled = False
        while self.arrived:
            message = self.arrived.popleft()
            header = message._connection_header
            if header.get('latching') == '1':
                self.latched[header['callerid']] = message
            for listener in list(self.listeners.values()):
                listener(bytes_of(message), header['type'])

    def add(self, key, listener):
        self.listeners[key] = listener
        for message in self.latched.values():
            listener(bytes_of(message), message._connection_header['type'])


def bytes_of(message):
    """Returns a serialised message. rospy gives deserialised ones of topics that it listens to itself (/clock)."""
    if isinstance(message, rospy.AnyMsg):
        return message._buff
    stream = io.BytesIO()
    message.serialize(stream)
    return stream.getvalue()


class RosGraph:
    """What there is in ROS. All functions are for the thread of the event loop."""

    def __init__(self):
        self.loop = asyncio.get_running_loop()
        self.topics = {}  # types of published topics, by name
        self.services = {}  # types of services that clients may call, by name
        self.service_types = {}  # of all, by name and node
        self.watchers = {}  # functions that are called when topics or services change
        self.listened = {}  # Topic by name
        self.keys = itertools.count()
        self.master = rosgraph.Master(rospy.get_name())
        self.executor = concurrent.futures.ThreadPoolExecutor(CALLS)
        self.wanted = asyncio.Event()
        self.looking = asyncio.Lock()

    async def run_forever(self):
        """Looks at the graph while somebody watches, until rospy ends."""
        while not rospy.is_shutdown():
            try:
                await asyncio.wait_for(self.wanted.wait(), POLL_PERIOD)
                await self.refresh()
                await asyncio.sleep(POLL_PERIOD)
            except asyncio.TimeoutError:
                pass

    async def refresh(self):
        """Asks the ROS master for topics and services."""
        try:
            async with self.looking:  # connections to the master are not for several threads
                found = await self.loop.run_in_executor(self.executor, self.look)
        except NO_MASTER:  # it may come back
            return
        if found != (self.topics, self.services):
            self.topics, self.services = found
            for watcher in list(self.watchers.values()):
                watcher()

    def look(self):
        publishers, _, services = self.master.getSystemState()
        types = dict(self.master.getTopicTypes())
        topics = {name: types[name] for name, _ in publishers if types.get(name, '*') != '*'}
        kinds = {name: self.type_of_service(name, tuple(nodes)) for name, nodes in services}
        return topics, {name: kind for name, kind in kinds.items() if kind.split('/')[0] in SERVED_PACKAGES}

    def type_of_service(self, name, nodes):
        """Returns the type of a service, '' if its node does not answer."""
        if (name, nodes) not in self.service_types:
            try:
                headers = rosservice.get_service_headers(name, self.master.lookupService(name))
                self.service_types[name, nodes] = headers['type']
            except (*NO_MASTER, KeyError, rosservice.ROSServiceException):
                return ''
        return self.service_types[name, nodes]

    def watch(self, key, watcher):
        """Calls a function at each change of topics and services, until unwatch()."""
        self.watchers[key] = watcher
        self.wanted.set()

    def unwatch(self, key):
        self.watchers.pop(key, None)
        if not self.watchers:
            self.wanted.clear()

    def listen(self, name, listener):
        """Calls a function with each message of a topic (bytes, type), and with the latched one. Returns a handle."""
        name = rospy.resolve_name(name)
        if name not in self.listened:
            self.listened[name] = Topic(self, name)
        handle = name, next(self.keys)
        self.listened[name].add(handle, listener)
        return handle

    def stop_listening(self, handle):
        topic = self.listened[handle[0]]
        topic.listeners.pop(handle, None)
        if not topic.listeners:
            topic.subscriber.unregister()
            del self.listened[handle[0]]

    def service_class(self, name):
        """Returns the class of a service that clients may call. Raises InputError."""
        if name not in self.services:
            raise InputError(f"there is no service '{name[:200]}' of {' or '.join(SERVED_PACKAGES)}")
        return self.class_of(self.services[name], roslib.message.get_service_class)

    def message_class(self, kind):
        """Returns the class of messages. Raises InputError."""
        return self.class_of(kind, roslib.message.get_message_class)

    @staticmethod
    def class_of(kind, find):
        try:
            found = find(kind)
        except (ValueError, ImportError, AttributeError):
            found = None
        if found is None:
            raise InputError(f"the type '{kind[:200]}' is not installed")
        return found

    async def call(self, name, request):
        """Calls a service. Returns the response. Raises InputError if that fails."""
        try:
            return await self.loop.run_in_executor(self.executor, self.call_now, name, request)
        except (rospy.ServiceException, rospy.ROSException, genpy.MessageException, OSError, ValueError) as error:
            raise InputError(f'{name}: {error}') from None

    @staticmethod
    def call_now(name, request):
        kind = roslib.message.get_service_class(type(request)._type[:-len('Request')])
        return rospy.ServiceProxy(name, kind)(request)
