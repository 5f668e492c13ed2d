#!/usr/bin/python3
"""Invalid parameters and scenario files: a node reports all errors in one message and ends with status 1."""
import os

import support
from learning_files import config_text
from social_crowd.msg import LearnerStatus

NAN, INFINITE = float('nan'), float('inf')
SCENE = """
name: scene
duration: 20
goal_tolerance: 0.3
agents:
  - {position: [0, 0], goal: [20, 0], speed: 0.5, radius: 0.25}
"""


class RefusalTestCase(support.CrowdTestCase):
    """A node that refuses to start."""

    def message_of(self, node):
        """Returns the message of a node that ends with an error: its last output."""
        self.assertEqual(node.wait(), 1, f'exit status of {node.name}; its output: {node.output()}')
        output = node.output()
        self.assertEqual(output.count('[FATAL]'), 1, output)
        return output[output.index('[FATAL]'):]

    def assert_all_named(self, node, *names):
        """Checks that a node names these parameters and no other."""
        message = self.message_of(node)
        self.assert_says(message, f'bad parameters of {self.namespace}/{node.name}')
        named = {line.split(':')[0].strip() for line in message.splitlines() if line.startswith('  ~')}
        self.assertEqual(named, {f'~{name}' for name in names}, message)
        return message


class ControllerParametersTest(RefusalTestCase):
    """Parameters of crowd_controller."""

    def start_plain(self, **parameters):
        """Starts a controller with these parameters only."""
        return self.start_node('crowd_controller', 'crowd_controller', parameters)

    def test_missing(self):
        message = self.assert_all_named(self.start_plain(), 'scenario')
        self.assert_says(message, 'expected a scenario file or name')

    def test_out_of_range(self):
        bad = {'seed': -1, 'episodes': -1, 'real_time_factor': -1.0, 'start_deadline': -1.0, 'answer_deadline': 0.0,
               'misses_until_absent': 0, 'agents_rate': -0.5, 'progress_distance': 0.0, 'progress_time': 0.0,
               'stalled_speed': -0.1}
        message = self.assert_all_named(self.start_plain(scenario=support.CIRCLE6, **bad), *bad)
        self.assert_says(message, 'got -0.5', 'from 0 to')

    def test_not_finite(self):
        bad = {'real_time_factor': INFINITE, 'start_deadline': NAN, 'answer_deadline': INFINITE, 'agents_rate': NAN}
        self.assert_all_named(self.start_plain(scenario=support.CIRCLE6, **bad), *bad)

    def test_wrong_type(self):
        bad = {'scenario': [1, 2], 'scenario_folder': {'a': 1}, 'seed': 'one', 'episodes': 2.5,
               'real_time_factor': 'quick', 'paused': 'yes', 'start_deadline': 'soon',
               'answer_deadline': True, 'misses_until_absent': 3.0,
               'agents_rate': [6.0], 'publish_tf': 1, 'publish_clock': 'true', 'trajectories': True}
        self.assert_all_named(self.start_plain(**bad), *bad)

    def test_unknown(self):
        message = self.assert_all_named(self.start_plain(scenario=support.CIRCLE6, sede=3, answers={'deadline': 1.0}),
                                        'sede', 'answers')
        self.assert_says(message, 'no such parameter', '~seed', '~answer_deadline')

    def test_misspelt(self):
        """The error suggests the most similar names; the lists of names do not contain misspelt ones."""
        message = self.assert_all_named(self.start_plain(scenario=support.CIRCLE6, real_time_facter=3, epsiodes=1),
                                        'real_time_facter', 'epsiodes')
        self.assert_says(message, "~real_time_facter: there is no such parameter, did you mean '~real_time_factor'? "
                         'There are ~agents_rate, ',
                         "~epsiodes: there is no such parameter, did you mean '~episodes'? There are ~agents_rate, ")
        for line in message.splitlines():
            self.assertNotIn('~real_time_facter', line.partition('There are')[2])

    def test_left_over_from_an_earlier_start(self):
        """The message contains the command that removes it from the parameter server."""
        name = f'{self.namespace}/crowd_controller/paces'
        message = self.assert_all_named(self.start_plain(scenario=support.CIRCLE6, paces=1), 'paces')
        self.assert_says(message, f'It may be left from an earlier start: rosparam delete {name}\n')

    def test_misspelt_required_parameter(self):
        """It is reported as misspelt, and not as missing as well."""
        message = self.assert_all_named(self.start_plain(scenaro=support.CIRCLE6), 'scenaro')
        self.assert_says(message, "did you mean '~scenario'?")

    def test_unreadable_configuration(self):
        config = self.write('config.yaml', config_text('circel6', 1))
        message = self.assert_all_named(self.start_plain(config=config), 'config')
        self.assert_says(message, f'{config}: line 5: training.scenarios[0]', "did you mean 'circle6'?")

    def test_all_at_once(self):
        """One message names missing, wrong, not finite and unknown parameters."""
        self.assert_all_named(self.start_plain(seed='x', agents_rate=NAN, no_such_name=1), 'scenario', 'seed',
                              'agents_rate', 'no_such_name')

    def test_accepts_whole_numbers_and_texts_as_numbers(self):
        """roslaunch and rosparam pass numbers in these forms."""
        node = self.start_controller(self.write('scene.yaml', SCENE), real_time_factor='2', answer_deadline=1,
                                     agents_rate=6, paused=True)
        self.succeed('crowd_controller/pause', data=True)
        self.assertTrue(node.is_running())

    def test_folder_for_recordings_that_cannot_be_created(self):
        file = self.write('file', '')
        for name in ('trajectories', 'robot_series', 'robot_logs'):
            node = self.start_plain(scenario=support.CIRCLE6, **{name: file})
            self.assert_says(self.message_of(node), file)

    def test_recordings_of_the_same_names(self):
        folder = self.path('recorded')
        for same in (folder, f'{folder}/', f'{folder}/../recorded'):
            message = self.assert_all_named(self.start_plain(scenario=support.CIRCLE6, trajectories=folder,
                                                             robot_series=same, robot_logs=folder), 'robot_series')
            self.assert_says(message, 'expected another folder than that of ~trajectories', same)


class ScenarioFilesTest(RefusalTestCase):
    """Scenario files with errors, when crowd_controller starts."""

    def refusal(self, scenario, **parameters):
        """Starts a controller with an invalid scenario. Returns its message."""
        return self.message_of(self.start_controller(scenario, **parameters))

    def check(self, text, *words):
        """Checks that the message contains the file and these words."""
        file = self.write('scene.yaml', text)
        self.assert_says(self.refusal(file), file, *words)

    def test_unknown_key(self):
        self.check(f'{SCENE}---{SCENE}colour: red\n', 'document 2', 'line 13', 'colour')

    def test_missing_number(self):
        self.check(SCENE.replace('goal_tolerance: 0.3\n', ''), 'document 1', 'line 2', 'goal_tolerance')

    def test_text_instead_of_a_number(self):
        self.check(SCENE.replace('speed: 0.5', 'speed: fast'), 'document 1', 'line 6', 'speed', "'fast'")

    def test_number_that_is_not_finite(self):
        self.check(SCENE.replace('radius: 0.25', 'radius: .nan'), 'document 1', 'line 6', 'radius')

    def test_overlapping_bodies(self):
        again = '  - {position: [0.2, 0], goal: [20, 0], speed: 0.5, radius: 0.25}\n'
        self.check(f'{SCENE}---{SCENE}{again}', 'document 2', 'agents[0]', 'agents[1]', 'overlap')

    def test_invalid_yaml(self):
        self.check(SCENE.replace(']', '', 1), 'line 6')

    def test_empty_file(self):
        self.check('', 'empty')

    def test_missing_file(self):
        self.assert_says(self.refusal(self.path('no_such_file.yaml')), self.path('no_such_file.yaml'))
        self.assert_says(self.refusal('no_such_name', scenario_folder=self.folder), 'no_such_name', self.folder)

    def test_unknown_name(self):
        """The message contains the folder and the existing names, the most similar first."""
        self.assert_says(self.refusal('circel6'), "no scenario 'circel6', did you mean 'circle6'? There is no file ",
                         os.path.join(os.getcwd(), 'circel6'), support.in_package('config', 'scenarios'),
                         'there are circle6, ')


class LearnerParametersTest(RefusalTestCase):
    """Parameters of learner."""

    def start_plain(self, **parameters):
        """Starts a learner with these parameters only."""
        return self.start_node('learner', 'learner', parameters)

    def test_missing(self):
        self.assert_all_named(self.start_plain(), 'q_table')
        self.assert_all_named(self.start_plain(mode='training'), 'config')

    def test_out_of_range(self):
        bad = {'alpha': 0.0, 'gamma': 1.0, 'lambda': -0.1, 'epsilon': 1.1}
        message = self.message_of(self.start_plain(q_table=support.NEAREST_TABLE, **bad))
        self.assert_says(message, *bad, 'above 0')
        bad = {'agents': [0, -1], 'seed': -1, 'save_every': -1}
        self.assert_all_named(self.start_plain(q_table=support.NEAREST_TABLE, **bad), *bad)

    def test_each_parameter_is_named_once(self):
        bad = {'mode': 'demos', 'tables': 'both', 'on_share': 'mix', 'alpha': 2, 'gamma': 1.0, 'epsilon': 'lots'}
        message = self.assert_all_named(self.start_plain(q_table=support.NEAREST_TABLE, **bad), *bad)
        self.assert_says(message, "~mode: expected training or demo, got 'demos'", "~tables: expected shared or own, ",
                         '~on_share: expected replace or merge, ',
                         '~alpha: expected a number above 0, at most 1, got 2',
                         '~gamma: expected a number from 0 to below 1, got 1',
                         "~epsilon: expected a number from 0 to 1 or a schedule {from, to, episodes, shape}, "
                         "got 'lots'")

    def test_list_from_the_command_line(self):
        """roscpp sets a list from the command line as a text."""
        status = self.listen('learner_status', LearnerStatus)
        self.start_learner(arguments=['_agents:=[1, 2, 3]'])
        self.assertEqual(list(status.wait().agents), [1, 2, 3])

    def test_shares(self):
        message = self.assert_all_named(self.start_plain(q_table='anticipation', share=2, shares=2), 'share')
        self.assert_says(message, 'expected a number below ~shares, 2, got 2')
        message = self.assert_all_named(self.start_plain(q_table='anticipation', shares=2, agents=[1]), 'shares')
        self.assert_says(message, 'expected 1, because ~agents lists the agents, got 2')
        status = self.listen('learner_status', LearnerStatus)
        self.start_learner(q_table='anticipation', share=1, shares=2)
        told = status.wait()
        self.assertEqual((told.serves_all, told.share, told.shares, list(told.agents)), (False, 1, 2, []))

    def test_unknown_name_of_a_table(self):
        message = self.assert_all_named(self.start_plain(q_table='anticipatoin'), 'q_table')
        self.assert_says(message, "no Q-table 'anticipatoin', did you mean 'anticipation'?")

    def test_invalid_lists(self):
        """The error quotes lists as they were set."""
        expected = '~agents: expected a list of whole numbers of at least 0, such as [0, 1, 2], got '
        for given in ('[1,x]', '[1, -2]', '[1, 2', '1 2', '{1: 2}', '[1.5]', '["1"]'):
            node = self.start_learner(arguments=[f'_agents:={given}'])
            self.assert_says(self.message_of(node), f"{expected}'{given}'\n")
        self.assert_says(self.message_of(self.start_learner(agents=[1, 'x'])), f"{expected}[1, 'x']\n")

    def test_not_finite(self):
        bad = {'alpha': NAN, 'gamma': INFINITE, 'lambda': -INFINITE, 'epsilon': NAN}
        self.assert_says(self.message_of(self.start_plain(q_table=support.NEAREST_TABLE, **bad)), *bad)

    def test_wrong_type(self):
        bad = {'mode': 3, 'tables': 'mine', 'on_share': True, 'agents': 'all', 'seed': 1.5, 'save_to': [1],
               'alpha': 'small', 'config': {'a': 1}}
        self.assert_all_named(self.start_plain(q_table=support.NEAREST_TABLE, **bad), *bad)

    def test_contradictory(self):
        config = self.write('config.yaml', config_text(support.CIRCLE6, 1))
        bad = {'q_table': support.OCCUPANCY_TABLE, 'config': config, 'save_every': 5, 'agents': [1, 2, 1]}
        message = self.assert_all_named(self.start_plain(mode='training', **bad), 'q_table', 'save_every', 'agents')
        self.assert_says(message, 'another state set', 'save_to', 'agent 1')

    def test_unknown(self):
        message = self.assert_all_named(self.start_plain(q_table=support.NEAREST_TABLE, agnets=[1]), 'agnets')
        self.assert_says(message, "did you mean '~agents'?")

    def test_misspelt_required_parameter(self):
        message = self.assert_all_named(self.start_plain(q_tabel=support.NEAREST_TABLE), 'q_tabel')
        self.assert_says(message, "did you mean '~q_table'?")

    def test_empty_text_is_treated_as_unset(self):
        """So a launch file can use epsilon and its schedule of the configuration."""
        config = config_text(support.CIRCLE6, 1, learning='{alpha: 0.2, epsilon: {from: 0.8, to: 0.2, episodes: 10}}')
        status = self.listen('learner_status', LearnerStatus)
        self.start_plain(mode='training', config=self.write('config.yaml', config), epsilon='', alpha='')
        message = status.wait()
        self.assertEqual((message.alpha, message.epsilon), (0.2, 0.8))

    def test_schedule_of_epsilon(self):
        """As a text, as roslaunch sets it, and as a map of parameters; a learner begins with episode 0."""
        for given in ('{from: 0.5, to: 0.125, episodes: 10}', {'from': 0.5, 'to': 0.125, 'episodes': 10}):
            status = self.listen('learner_status', LearnerStatus)
            node = self.start_plain(mode='training', q_table=support.NEAREST_TABLE, epsilon=given)
            self.assertEqual(status.wait(lambda message: message.mode == 'training').epsilon, 0.5)
            said = self.succeed('learner/set_learning_parameters', parameters='{gamma: 0.25}').message
            self.assert_says(said, 'epsilon: {from: 0.5, to: 0.125, episodes: 10, shape: linear}')
            self.assertEqual(node.stop(), 0)
        wrong = self.start_plain(q_table=support.NEAREST_TABLE, epsilon='{from: 2, to: 0, episodes: 9}')
        self.assert_says(self.assert_all_named(wrong, 'epsilon'), "from: expected a number from 0 to 1, got '2'")

    def test_unreadable_files(self):
        table = self.write('table.txt', 'no table')
        config = self.write('config.yaml', config_text(support.CIRCLE6, 1) + 'colour: red\n')
        message = self.assert_all_named(self.start_plain(mode='training', q_table=table, config=config), 'q_table',
                                        'config')
        self.assert_says(message, table, 'line 1', config, 'colour')
        missing = self.path('missing.txt')
        self.assert_says(self.assert_all_named(self.start_plain(q_table=missing), 'q_table'), missing)

    def test_unwritable_file(self):
        """It is reported at the start, not after the training."""
        file = self.path('no_such_folder/table.txt')
        message = self.message_of(self.start_plain(q_table=support.NEAREST_TABLE, mode='training', save_to=file))
        self.assert_says(message, f'~save_to: {file}: cannot be written',
                         f'there is no folder {self.path("no_such_folder")}')

    def test_unwritable_relative_file(self):
        file = self.path('no_such_folder/table.txt')
        message = self.message_of(self.start_plain(q_table=support.NEAREST_TABLE, save_to=os.path.relpath(file)))
        self.assert_says(message, f'~save_to: {file}: cannot be written')

    def test_all_at_once(self):
        bad = {'mode': 'demos', 'tables': 'both', 'agents': [0.5], 'no_such_name': 1}
        self.assert_all_named(self.start_plain(q_table=self.path('missing.txt'), **bad), 'q_table', *bad)


class CrewParametersTest(RefusalTestCase):
    """Parameters of learner_crew."""

    def test_wrong_learners(self):
        crew = self.start_node('learner_crew', 'learner_crew', {'learners': 'two'})
        self.assertEqual(crew.wait(), 1)
        self.assert_says(crew.output(), 'learners', 'per_agent', "'two'")

    def test_rosrun_finds_it(self):
        crew = self.start('crew', ['rosrun', 'social_crowd', 'learner_crew', '_learners:=two'])
        self.assertEqual(crew.wait(), 1)
        self.assert_says(crew.output(), 'learners: expected one, per_agent or none')


if __name__ == '__main__':
    support.run('parameters_test')
