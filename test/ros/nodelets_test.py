#!/usr/bin/python3
"""Controller, learner and markers as nodelets: same behaviour as the nodes, loading and unloading."""
import os
import re
import signal
import xmlrpc.client

import rosgraph
import rospy
import support
from learning_files import QTableFile, config_text
from social_crowd.msg import AgentStates, EpisodeResult, LearnerStatus, Perceptions
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

SCENARIO = support.data('lockstep.yaml')
EPISODES = 12  # so that each of the six documents is walked twice
LOADER = ['rosrun', 'nodelet', 'nodelet']
# The program that runs nodelets; scripts/test --sanitizer replaces ROS's.
NODELET = [os.environ['CROWD_NODELET']] if 'CROWD_NODELET' in os.environ else LOADER


def catches_interrupt(pid):
    """Returns whether a process is the loading program and has a handler of SIGINT, which it gets after the loading."""
    status = support.read_text(f'/proc/{pid}/status')
    caught = int(re.search(r'SigCgt:\s*(\w+)', status).group(1), 16)
    return 'Name:\tnodelet\n' in status and bool(caught >> (signal.SIGINT - 1) & 1)


def children(message):
    """Returns the child frames in a message of tf."""
    return {frame.child_frame_id for frame in message.transforms}


class NodeletTestCase(support.CrowdTestCase):
    """Loads nodelets into a manager."""

    def setUp(self):
        super().setUp()
        self.manager = self.start('manager', NODELET + ['manager', '__name:=manager'])

    def load(self, kind, name='', **parameters):
        """Starts the process that loads a nodelet, and unloads it when it is interrupted. Waits until it has loaded it:
        an interrupt before would end it without unloading."""
        name = name or kind
        for key, value in parameters.items():
            rospy.set_param(f'{self.namespace}/{name}/{key}', value)
        loader = self.start(f'load_{name}', LOADER + ['load', f'social_crowd/{kind}', 'manager', f'__name:={name}'])
        support.wait_for(lambda: not loader.is_running() or catches_interrupt(loader.process.pid), loader.name)
        return loader

    def load_controller(self, scenario=SCENARIO, **parameters):
        """Loads a controller with long deadlines."""
        patient = {'scenario': scenario, 'real_time_factor': 'fast', 'start_deadline': 120.0, 'answer_deadline': 60.0}
        return self.load('crowd_controller', **dict(patient, **parameters))

    def publishers(self, topic):
        """Returns the names of the nodes that publish a topic."""
        publishers = rosgraph.Master('/nodelets_test').getSystemState()[0]
        return [name for entry, names in publishers if entry == f'{self.namespace}/{topic}' for name in names]

    def assert_manager_is_well(self):
        """Checks that the manager still runs, and that it ends properly after all nodelets are unloaded."""
        self.assertTrue(self.manager.is_running(), self.manager.output())
        for loader in self.processes[1:]:
            if loader.is_running():
                self.assertEqual(loader.stop(), 0, loader.name)
        # The manager unloads in a thread of its own, and cannot be interrupted meanwhile.
        try:
            support.wait_for(lambda: not self.publishers('actions') + self.publishers('agents'), 'the unloading')
        except AssertionError as error:
            left = {topic: self.publishers(topic) for topic in ('actions', 'agents')}
            self.fail(f'{error}; publishers: {left}\n{self.outputs()}')
        self.assertEqual(self.manager.stop(), 0)


class DemoTest(NodeletTestCase):
    """Compares the recording of a run with nodelets with that of `evaluate`."""

    def test_recording_equals_that_of_a_run_without_ros(self):
        for table in (support.NEAREST_TABLE, support.ANTICIPATION_TABLE):
            folder = self.path(os.path.basename(table))
            learner = self.load('learner', q_table=table)
            controller = self.load_controller(episodes=EPISODES, seed=5, trajectories=folder)
            self.assertEqual(controller.wait(), 0)  # it unloads itself, and the loading program ends
            recording = support.read_bytes(os.path.join(folder, 'lockstep.csv'))
            self.assert_same_recording(recording, self.headless(SCENARIO, table, episodes=EPISODES, seed=5))
            self.assertEqual(learner.stop(), 0)
        self.assert_manager_is_well()

    def test_a_learner_node_and_a_controller_nodelet(self):
        self.start_learner()
        controller = self.load_controller(episodes=EPISODES, seed=5, trajectories=self.path('ros'))
        self.assertEqual(controller.wait(), 0)
        expected = self.headless(SCENARIO, episodes=EPISODES, seed=5)
        self.assert_same_recording(support.read_bytes(self.path('ros/lockstep.csv')), expected)

    def test_controller_without_a_manager(self):
        """Without a manager the nodelet ends its process after the last episode."""
        self.start_learner()
        parameters = {'scenario': support.CIRCLE6, 'real_time_factor': 'fast', 'episodes': 1, 'answer_deadline': 60.0}
        for key, value in parameters.items():
            rospy.set_param(f'{self.namespace}/crowd_controller/{key}', value)
        alone = self.start('alone', NODELET + ['standalone', 'social_crowd/crowd_controller',
                                               '__name:=crowd_controller'])
        self.assertEqual(alone.wait(), 0)
        self.assert_says(alone.output(), 'episode 0 (circle6')

    def test_two_learner_nodelets(self):
        self.load('learner', 'learner_a', q_table=support.NEAREST_TABLE, agents=[0, 1, 2])
        self.load('learner', 'learner_b', q_table=support.NEAREST_TABLE, agents=[3, 4, 5])
        results = self.listen('episode_results', EpisodeResult)
        controller = self.load_controller(episodes=EPISODES, seed=5, trajectories=self.path('ros'), paused=True)
        results.wait_connected()
        self.succeed('crowd_controller/pause', data=False)
        self.assertEqual(controller.wait(), 0)
        expected = self.headless(SCENARIO, episodes=EPISODES, seed=5)
        self.assert_same_recording(support.read_bytes(self.path('ros/lockstep.csv')), expected)

    def test_learners_with_different_visions(self):
        """The learner of all agents has a vision of 1 m, another one without agents has 6 m."""
        self.load('learner', 'learner_a', q_table=support.NEAREST_TABLE)
        self.load('learner', 'learner_b', q_table=support.ANTICIPATION_TABLE, agents=[99])
        perceptions = self.listen('perceptions', Perceptions)
        results = self.listen('episode_results', EpisodeResult)
        controller = self.load_controller(episodes=EPISODES, seed=5, trajectories=self.path('ros'), paused=True)
        results.wait_connected()
        perceptions.wait_connected()
        self.step_until_wide(perceptions)
        self.succeed('crowd_controller/pause', data=False)
        self.assertEqual(controller.wait(), 0)
        expected = self.headless(SCENARIO, episodes=EPISODES, seed=5)
        self.assert_same_recording(support.read_bytes(self.path('ros/lockstep.csv')), expected)

    def test_status_of_learners_loaded_before_the_controller(self):
        """The controller receives the status of each learner of its process, not only the latest one."""
        self.load('learner', 'learner_wide', q_table=support.ANTICIPATION_TABLE, agents=[99])
        self.load('learner', 'learner_of_all', q_table=support.NEAREST_TABLE)
        perceptions = self.listen('perceptions', Perceptions)
        self.load_controller(paused=True)
        perceptions.wait_connected()
        self.step_until_wide(perceptions)

    def step_until_wide(self, perceptions):
        """Walks until perceptions contain the vision of the table `anticipation`."""

        def is_wide():
            self.step(1)
            return any(message.vision_radius > 6.0 for message in perceptions.messages)

        support.wait_for(is_wide, 'perceptions with the wider vision')

    def test_ticks_are_passed_by_pointer(self):
        """roscpp counts the bytes of serialised messages; there are none for pointers."""
        self.load('learner', q_table=support.NEAREST_TABLE)
        self.load_controller(paused=True)
        self.step(1)  # what is sent to a new subscriber is serialised
        topics = ('perceptions', 'actions')
        before = {topic: self.received(topic) for topic in topics}
        self.step(20)
        for topic in topics:
            messages, size = self.received(topic)
            self.assertGreaterEqual(messages - before[topic][0], 20, topic)
            self.assertEqual(size, before[topic][1], topic)
        self.assertGreater(self.received('learner_status')[1], 0, 'otherwise roscpp would not count')

    def test_topics_of_learners_loaded_before_the_controller(self):
        """The controller receives the status of both; the perceptions of their agents are passed by pointer, too."""
        agents = {'learner_a': [0, 1, 2], 'learner_b': [3, 4, 5]}
        for name, served in agents.items():
            self.load('learner', name, q_table=support.NEAREST_TABLE, agents=served)
        self.load_controller(support.CIRCLE6, paused=True)
        self.step(1)  # what is sent to a new subscriber is serialised
        topics = [f'perceptions{self.namespace}/{name}' for name in agents]
        before = {topic: self.received(topic) for topic in topics}
        self.step(20)
        for topic in topics:
            messages, size = self.received(topic)
            self.assertGreaterEqual(messages - before[topic][0], 20, topic)
            self.assertEqual(size, before[topic][1], topic)
        self.assertEqual(self.received('perceptions'), (0, 0))

    def test_frames(self):
        """Broadcasters of all nodelets share the manager's publishers of /tf and /tf_static."""
        frames, static_frames = self.listen('/tf', TFMessage), self.listen('/tf_static', TFMessage)
        self.load('crowd_markers')
        self.load('learner', q_table=support.NEAREST_TABLE)
        self.load_controller(paused=True, publish_tf=True)
        frames.wait_connected()
        self.step(1)
        frames.wait(lambda message: {'agent_0', 'agent_1'} <= children(message), 'with the frames of agents')
        static_frames.wait(lambda message: children(message) == {'crowd'}, 'with the frame of the crowd')

    def received(self, topic):
        """Returns the numbers of messages and bytes of a topic that nodelets have received."""
        master = rosgraph.Master('/nodelets_test')
        manager = xmlrpc.client.ServerProxy(master.lookupNode(f'{self.namespace}/manager'))
        subscriptions = manager.getBusStats('/nodelets_test')[1]
        links = [link for name, links in subscriptions if name == f'{self.namespace}/{topic}' for link in links]
        return sum(link[2] for link in links), sum(link[1] for link in links)


class TrainingTest(NodeletTestCase):
    """Compares the table learned in a nodelet with that of `train`."""

    def test_table_equals_that_of_a_run_without_ros(self):
        learning = '{alpha: 0.2, gamma: 0.9, lambda: 0.8, epsilon: {from: 0.6, to: 0.1, episodes: 4}}'
        config = self.write('config.yaml', config_text(SCENARIO, 7, 3, 'shared', learning))
        self.tool('train', config, '--output', self.path('headless.txt'))
        decisions = QTableFile(self.path('headless.txt')).header['decisions']
        status = self.listen('learner_status', LearnerStatus)
        learner = self.load('learner', mode='training', config=config, seed=3, save_to=self.path('ros.txt'),
                            data_folder=self.folder)
        status.wait(what='that the learner is there')
        self.assertEqual(self.load_controller(episodes=7, seed=3).wait(), 0)

        self.wait_until_learned('learner', decisions)
        self.succeed('learner/save_q_table', file=self.path('saved.txt'))
        self.assertEqual(learner.stop(), 0)  # unloads it, and it saves its table
        support.wait_for(lambda: support.read_bytes(self.path('ros.txt')), 'the table saved at the end')
        self.assertEqual(support.read_text(self.path('ros.txt')), support.read_text(self.path('headless.txt')))
        self.assert_manager_is_well()


class LoadingTest(NodeletTestCase):
    """Loading and unloading of nodelets."""

    def test_learner_is_unloaded_and_loaded_again(self):
        agents = self.listen('agents', AgentStates)
        learner = self.load('learner', q_table=support.NEAREST_TABLE)
        self.load_controller(support.CIRCLE6, paused=True)
        agents.wait_connected()
        self.step(3)
        self.assertEqual(learner.stop(), 0)
        support.wait_for(lambda: not self.publishers('actions'), 'the unloading')
        later = self.call_later('crowd_controller/step', ticks=3)
        self.load('learner', q_table=support.NEAREST_TABLE)
        self.assertTrue(later.result('an answer of the learner that came').success)
        moved = agents.wait_at(0, 6).agents[0].pose
        self.assertNotEqual((moved.x, moved.y), (agents.wait_at(0, 3).agents[0].pose.x, moved.y))
        self.assert_manager_is_well()

    def test_controller_is_unloaded_while_it_waits(self):
        """It waits for a learner that never answers; other nodelets of the manager are not affected."""
        self.load('crowd_markers')
        status = self.listen('learner_status', LearnerStatus)
        for _ in range(2):
            controller = self.load_controller()
            self.assertEqual(controller.stop(), 0)
            support.wait_for(lambda: not self.publishers('perceptions'), 'the unloading')
        self.load('learner', q_table=support.NEAREST_TABLE)
        status.wait(what='of another nodelet')
        self.assert_manager_is_well()

    def test_error_names_invalid_parameters_and_the_manager_continues(self):
        refused = self.load_controller(real_time_factor='slow', no_such_name=1)
        self.assertNotEqual(refused.wait(), 0)
        support.wait_for(lambda: '~no_such_name' in self.manager.output(), 'a message of the manager')
        self.assert_says(self.manager.output(), 'bad parameters', '~real_time_factor', "'slow'")
        rospy.delete_param(f'{self.namespace}/crowd_controller')
        self.load('learner', q_table=support.NEAREST_TABLE)
        self.assertEqual(self.load_controller(episodes=1).wait(), 0)
        self.assert_manager_is_well()

    def test_markers(self):
        markers = self.listen('markers', MarkerArray)
        self.load('crowd_markers')
        self.load('learner', q_table=support.NEAREST_TABLE)
        self.load_controller(real_time_factor=1.0)
        markers.wait(lambda array: any(marker.ns == 'paths' and marker.points for marker in array.markers), 'of paths')


if __name__ == '__main__':
    support.run('nodelets_test')
