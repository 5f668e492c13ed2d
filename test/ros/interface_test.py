#!/usr/bin/python3
"""The tables of topics, services and parameters in docs/ agree with those of running nodes."""
import re

import documented
import rosgraph
import rosservice
import rospy
import support

PAGES = {'crowd_controller': 'ros.md', 'learner': 'ros.md', 'crowd_markers': 'ros.md', 'crowd_editor': 'rviz.md',
         'robot_controller': 'ros.md'}
TITLES = {'crowd_editor': 'Editor'}  # of sections, if not the name of the node
TABLES = 'publishes', 'subscribes to', 'service'  # first columns on the pages
OF_ALL_NODES = {'get_loggers', 'set_logger_level'}  # services that roscpp adds
SHARED = {'/rosout', '/clock'}  # roscpp adds them
# Relative topics of a robot in its name space, which are in docs/robots.md.
ROBOT = """
name: robot
duration: 20
goal_tolerance: 0.3
map: map.yaml
agents:
  - {position: [1, 1], goal: [3, 1], speed: 0.5, radius: 0.25}
robots:
  - {name: robot, namespace: robot, position: [1, 3], goal: [3, 3], radius: 0.25, max_speed: 0.5,
     scan: {rings: 2, height: 0.5}}
"""
# Python nodes: the page, and the files that read the parameters; that of replay has a table of defaults.
SCRIPTS = {'goal_sender': ('move_base.md', ['crowd_launching/goal_sender.py', 'crowd_launching/back_off.py']),
           'record_robots': ('running.md', ['crowd_robots/recorder.py']),
           'replay': ('running.md', ['crowd_recordings/replay.py'])}


def text_of(node):
    """Returns the section of a node."""
    return documented.section(PAGES[node], TITLES.get(node, node))


class ParametersTest(support.CrowdTestCase):
    """Names, ranges, units and defaults of parameters."""

    def stated(self, node, documented_names):
        """Returns what a node logs about its parameters at its start. Nothing is logged after it was stopped."""
        config = self.write('debug.config', 'log4j.logger.ros.social_crowd=DEBUG\n')
        self.environment.update(ROSCONSOLE_CONFIG_FILE=config, ROSCONSOLE_FORMAT='${message}')
        process = self.start_node(node, node, {})
        support.wait_for(lambda: not process.is_running() or documented_names <= set(
            documented.stated_parameters(process.output())), f'the parameters of {node}: {documented_names}')
        process.stop()
        stated = documented.stated_parameters(process.output())
        self.assertTrue(stated, process.output())
        return stated

    def test_nodes(self):
        for node in PAGES:
            about = documented.parameters(text_of(node))
            stated = self.stated(node, set(about))
            self.assertEqual(set(about), set(stated), node)
            problems = [f'{node}: ~{name}: {problem}' for name in sorted(stated)
                        for problem in differences(about[name], *stated[name])]
            self.assertEqual(problems, [])

    def test_scripts(self):
        for node, (page, files) in SCRIPTS.items():
            code = ''.join(support.read_text(support.in_package('scripts', file)) for file in files)
            read = dict(re.findall(r"get_param\('~(\w+)', ([^)]*)\)", code))
            table = re.search(r'^DEFAULTS = \{(.*?)\}', code, re.DOTALL | re.MULTILINE)
            if table:
                read.update(re.findall(r"'(\w+)': ([^,}]+)", table[1]))
            about = documented.parameters(documented.section(page, node))
            self.assertEqual(set(about), set(read), node)
            for name, default in read.items():
                self.assertEqual(as_number(about[name].default), as_number(default.strip("'").lower()),
                                 f'{node}: ~{name}: default')


def differences(about, expected, default):
    """Compares a row of a table with what the node expects. Returns the differences."""
    limits, found = documented.stated_range(expected), documented.documented_range(about.range)
    if limits != found:
        yield f"range '{about.range}', in the code '{expected}'"
    if not limits and expected not in ('true or false', 'a text') and 'list' not in expected:
        missing = [choice for choice in re.split(', | or ', expected) if f'`{choice}`' not in about.meaning]
        if missing:
            yield f'the choices {missing} are not documented'
    of_a_file = about.default.startswith(('that of', 'those of')) and 'else' not in about.default
    if not of_a_file and as_number(documented_default(about.default)) != as_number(default):
        yield f"default '{about.default}', in the code '{default}'"


def documented_default(cell):
    """Returns the value in a cell such as "that of `~config`, else 1"."""
    value = cell.split('else ')[-1].replace('`', '')
    folder, of_package, _ = value.partition(' of the package')
    return support.in_package(folder) if of_package else value


def as_number(text):
    """Returns a number for the text of one, else the text."""
    try:
        return float(text)
    except ValueError:
        return text


class GraphTest(support.CrowdTestCase):
    """Names and types of topics and services, as the ROS master has them."""

    def start_all(self):
        """Starts all nodes, each with everything that it can advertise."""
        self.write('map.pgm', 'P2\n4 4\n255\n' + '254 ' * 16 + '\n')
        self.write('map.yaml', 'image: map.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n'
                               'occupied_thresh: 0.65\nfree_thresh: 0.196\n')
        self.start_learner()
        self.start_controller(self.write('robot.yaml', ROBOT), paused=True, publish_tf=True, publish_clock=True)
        self.start_node('crowd_editor', 'crowd_editor', {})
        self.start_node('robot_controller', 'robot_controller', {})
        self.start_node('crowd_markers', 'crowd_markers', {})
        self.markers = self.listen('markers', rospy.AnyMsg)
        self.diagnostics = self.listen('/diagnostics', rospy.AnyMsg)
        self.step()  # all nodes of a tick are there
        support.wait_for(lambda: all(self.topics(kind, node) for kind in (0, 1) for node in PAGES) and
                         {'perceptions', 'decision_values'} <= set(self.topics(1, 'crowd_markers')) and
                         'chosen_agent' in self.topics(1, 'learner'), 'all nodes')

        # A node registers one name after the other.
        support.wait_for(lambda: all(set(documented.typed(text_of(node), title)) <= self.names(kind, node)
                                     for node in PAGES for kind, title in enumerate(TABLES)), 'all names')

    def names(self, kind, node):
        """Returns the topics that a node publishes or subscribes to, or its services."""
        if kind < 2:
            return set(self.topics(kind, node))
        prefix = f'{self.namespace}/{node}/'
        return {f'~{name[len(prefix):]}' for name in rosservice.get_service_list(node=prefix[:-1])}

    def topics(self, kind, node):
        """Returns {topic: type} that a node publishes (kind 0) or subscribes to (kind 1); names relative to the test.
        The type is None if the topic has no publisher."""
        master = rosgraph.Master('/interface_test')
        types, full_name = dict(master.getTopicTypes()), f'{self.namespace}/{node}'
        names = [topic for topic, nodes in master.getSystemState()[kind] if full_name in nodes]
        kinds = {name: types[name] if types.get(name, '*') != '*' else None for name in names}
        return {self.relative(name, node): kind for name, kind in kinds.items()
                if name not in SHARED or node == 'crowd_controller' and kind and name == '/clock'}

    def relative(self, name, node):
        """Returns a name as the pages write it."""
        private, public = f'{self.namespace}/{node}/', f'{self.namespace}/'
        if name.startswith(private) and node != 'crowd_editor':
            return f'~{name[len(private):]}'
        return name[len(public):] if name.startswith(public) else name

    def assert_documented(self, found, about, node):
        """Compares names and types with those of a page."""
        self.assertEqual(set(found), set(about), node)
        known = {name: kind for name, kind in found.items() if kind}
        self.assertEqual(known, {name: about[name] for name in known}, node)

    def test_topics(self):
        self.start_all()
        for node in PAGES:
            publishes = documented.typed(text_of(node), 'publishes')
            subscribes = documented.typed(text_of(node), 'subscribes to')
            published, subscribed = self.topics(0, node), self.topics(1, node)
            if node == 'crowd_controller':
                self.assert_robot_documented(published, subscribed, publishes)
            self.assert_documented(published, publishes, f'{node} publishes')
            self.assert_documented(subscribed, subscribes, f'{node} subscribes to')

    def assert_robot_documented(self, published, subscribed, publishes):
        """Compares the topics of the robot with docs/robots.md, which says which are subscribed to. Removes them."""
        page = documented.section('robots.md', 'Topics')
        about = {name: kind for name, kind in documented.typed(page, 'topic').items() if not name.startswith('/')}
        inputs = {name for cells in documented.rows(page, 'topic') if '(subscribed)' in cells[0]
                  for name in documented.names_in(cells[0])}
        # Only where people_msgs or spencer_tracking_msgs is installed.
        optional = {'people', 'people_tracker_measurements', 'tracked_persons'}
        found = {}
        for topics in (published, subscribed):
            for name in [name for name in topics if name.startswith('robot/')]:
                self.assertEqual(topics is subscribed, name[6:] in inputs, name)
                found[name[6:]] = topics.pop(name)
        published.pop('/tf_static')  # of the robot
        self.assert_documented(found, {name: kind for name, kind in about.items()
                                       if name in found or name not in optional}, 'robot')
        self.assertEqual(published.keys() - publishes.keys(), set())

    def test_services(self):
        self.start_all()
        for node in PAGES:
            prefix = f'{self.namespace}/{node}/'
            names = [name for name in rosservice.get_service_list(node=prefix[:-1])
                     if name[len(prefix):] not in OF_ALL_NODES]
            found = {f'~{name[len(prefix):]}': rosservice.get_service_type(name) for name in names}
            self.assert_documented(found, documented.typed(text_of(node), 'service'), node)


if __name__ == '__main__':
    support.run('interface_test')
