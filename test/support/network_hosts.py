"""Hosts in network namespaces: a switch, and hosts with an address each, whose links can be cut.

Needs root and iproute2. Everything is in namespaces of its own, so that nothing of the machine's network is changed.
"""
import contextlib
import json
import os
import re
import shutil
import signal
import subprocess
import time

NETWORK = '10.77.0'
PREFIX = 'social_crowd'
OWN_NAME = re.compile(rf'^{PREFIX}_(\d+)_')
MASTER_PORT = 11311  # in a namespace: there is no other master
END = 5.0  # [s] time for programs in a namespace to end after SIGTERM


def why_not():
    """Returns why there can be no hosts here; an empty text if there can."""
    if os.geteuid() != 0:
        return 'network namespaces need root'
    if shutil.which('ip') is None:
        return 'network namespaces need iproute2, there is no program ip'
    remove_leftovers()
    name = f'{PREFIX}_{os.getpid()}_probe'
    try:
        ip('netns', 'add', name)
        ip('-n', name, 'link', 'add', 'probe', 'type', 'bridge')
        ip('-n', name, 'link', 'add', 'one', 'type', 'veth', 'peer', 'name', 'other')
    except RuntimeError as error:
        return f'network namespaces are not available here: {error}'
    finally:
        subprocess.run(['ip', 'netns', 'delete', name], stderr=subprocess.DEVNULL, check=False)
    return ''


def remove_leftovers():
    """Removes the namespaces of test runs that were killed."""
    for name in namespaces():
        found = OWN_NAME.match(name)
        if found and not os.path.exists(f'/proc/{found[1]}'):
            end_programs_in(name)
            ip('netns', 'delete', name)


def namespaces():
    """Returns the names of all network namespaces."""
    return [line.split()[0] for line in ip('netns', 'list').splitlines() if line.strip()]


def programs_in(namespace):
    """Returns the processes in a namespace."""
    return [int(word) for word in ip('netns', 'pids', namespace).split()]


def end_programs_in(namespace):
    """Ends what runs in a namespace of a test."""
    for number in (signal.SIGTERM, signal.SIGKILL):
        for process in programs_in(namespace):
            with contextlib.suppress(ProcessLookupError):
                os.kill(process, number)
        deadline = time.monotonic() + END
        while programs_in(namespace) and time.monotonic() < deadline:
            time.sleep(0.02)


def ip(*words):
    """Runs ip. Returns its output."""
    done = subprocess.run(['ip', *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f'ip {" ".join(words)}: {done.stderr.strip()}')
    return done.stdout


class Host:
    """A host with an address, in a network namespace."""

    def __init__(self, network, name, number):
        self.network = network
        self.name = name
        self.address = f'{NETWORK}.{number}'
        self.namespace = network.namespace_of(name)
        self.port = f'port{number}'  # of the switch
        ip('netns', 'add', self.namespace)
        peer = ('peer', 'name', 'eth0', 'netns', self.namespace)
        ip('-n', network.switch, 'link', 'add', self.port, 'type', 'veth', *peer)
        ip('-n', network.switch, 'link', 'set', self.port, 'master', 'bridge', 'up')
        ip('-n', self.namespace, 'address', 'add', f'{self.address}/24', 'dev', 'eth0')
        for device in ('lo', 'eth0'):
            ip('-n', self.namespace, 'link', 'set', device, 'up')

    def command(self, *words):
        """Returns a command that runs on this host, without ROS_HOSTNAME, which has precedence over ROS_IP."""
        return ['ip', 'netns', 'exec', self.namespace, 'env', '--unset=ROS_HOSTNAME', *map(str, words)]

    def environment(self):
        """Returns the variables of ROS for programs on this host."""
        return {'ROS_IP': self.address, 'ROS_MASTER_URI': self.network.master, **self.network.variables}

    def cut(self):
        """Cuts the link at the switch: what is sent is lost."""
        ip('-n', self.network.switch, 'link', 'set', self.port, 'down')

    def restore(self):
        """Ends cut()."""
        ip('-n', self.network.switch, 'link', 'set', self.port, 'up')

    def impair(self, *words):
        """Delays or loses what the switch sends to this host, and what this host sends, with netem."""
        for namespace, device in ((self.network.switch, self.port), (self.namespace, 'eth0')):
            done = subprocess.run(['tc', '-n', namespace, 'qdisc', 'add', 'dev', device, 'root', 'netem', *words],
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            if done.returncode != 0:
                raise RuntimeError(f'tc qdisc add ... netem {" ".join(words)}: {done.stdout.strip()}')

    def traffic(self):
        """Returns the bytes that this host has received and sent so far, with the headers of all protocols."""
        link = json.loads(ip('-n', self.namespace, '-s', '-j', 'link', 'show', 'dev', 'eth0'))[0]['stats64']
        return link['rx']['bytes'], link['tx']['bytes']


class Network:
    """Context manager: a switch and its hosts. At its end all programs on the hosts end."""

    def __init__(self, variables=None):
        self.variables = variables or {}  # additional environment variables of all programs
        self.switch = self.namespace_of('switch')
        self.hosts = []
        self.master = ''

    def __enter__(self):
        try:
            ip('netns', 'add', self.switch)
            ip('-n', self.switch, 'link', 'add', 'bridge', 'type', 'bridge')
            ip('-n', self.switch, 'link', 'set', 'bridge', 'up')
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for name in namespaces():
            if name.startswith(self.namespace_of('')):
                end_programs_in(name)
                ip('netns', 'delete', name)

    @staticmethod
    def namespace_of(name):
        """Returns the name of a namespace, which contains the number of this process."""
        return f'{PREFIX}_{os.getpid()}_{name}'

    def add(self, name):
        """Adds a host. The ROS master is that of the first one."""
        host = Host(self, name, len(self.hosts) + 1)
        self.hosts.append(host)
        if len(self.hosts) == 1:
            self.master = f'http://{host.address}:{MASTER_PORT}'
        return host
