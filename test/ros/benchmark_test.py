#!/usr/bin/python3
"""The scenes of the steering benchmark through ROS, if the benchmark is beside the package."""
import glob
import os
import subprocess

import support

BENCHMARK = os.path.normpath(support.in_package('..', 'shared', 'benchmark'))
SCENARIOS = 18


class BenchmarkTest(support.CrowdTestCase):
    """All scenarios, and the benchmark's own scorer."""

    def setUp(self):
        super().setUp()
        self.scenarios = sorted(glob.glob(os.path.join(BENCHMARK, 'scenarios', '*.yaml')))
        if not self.scenarios:
            self.skip(f'there is no benchmark at {BENCHMARK}')
        self.assertEqual(len(self.scenarios), SCENARIOS)

    def first_instances(self):
        """Returns a file with the first instance of each scenario."""
        first = [support.read_text(file).split('\n---\n')[0] for file in self.scenarios]
        return self.write('first.yaml', '\n'.join(text if text.startswith('---') else f'---\n{text}' for text in first))

    def walk(self, scenario, episodes):
        """Walks a number of instances through ROS. Returns the recording."""
        controller = self.start_controller(scenario, episodes=episodes, trajectories=self.path('ros'))
        self.assertEqual(controller.wait(), 0)
        return support.read_bytes(self.path('ros/' + support.recording_of(scenario)))

    def check_first_instances(self, table):
        """The first instance of each scenario gives the same recording as without ROS."""
        scenario = self.first_instances()
        self.start_learner(q_table=table)
        got = by_instance(self.walk(scenario, SCENARIOS))
        expected = by_instance(self.headless(scenario, table))
        self.assertEqual(sorted(expected), list(range(SCENARIOS)))
        different = [os.path.basename(file) for i, file in enumerate(self.scenarios) if got.get(i) != expected[i]]
        self.assertEqual(different, [], 'scenarios walked otherwise than without ROS')

    def test_first_instances_nearest(self):
        self.check_first_instances(support.NEAREST_TABLE)

    def test_first_instances_occupancy(self):
        self.check_first_instances(support.OCCUPANCY_TABLE)

    def test_first_instances_anticipation(self):
        self.check_first_instances(support.ANTICIPATION_TABLE)

    def check_score(self, name):
        """All 50 instances of a scenario give the same recording as without ROS, and the scorer can read it."""
        scenario = os.path.join(BENCHMARK, 'scenarios', f'{name}.yaml')
        self.start_learner()
        self.assert_same_recording(self.walk(scenario, 50), self.headless(scenario))
        command = ['/usr/bin/python3', os.path.join(BENCHMARK, 'score.py'), os.path.dirname(self.link(scenario)),
                   self.path('ros'), '--csv', self.path('score.csv')]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=support.PATIENCE,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout.decode(errors='replace'))
        header, row = support.read_text(self.path('score.csv')).splitlines()
        self.assertEqual(row.split(',')[:2], [name, '50'], header)

    def link(self, scenario):
        """Returns a folder with this scenario only, so that the scorer expects no others."""
        os.mkdir(self.path('scenarios'))
        os.symlink(scenario, self.path(f'scenarios/{os.path.basename(scenario)}'))
        return self.path(f'scenarios/{os.path.basename(scenario)}')

    def test_score_of_free(self):
        self.check_score('free')

    def test_score_of_circle6(self):
        self.check_score('circle6')


def by_instance(recording):
    """Returns the rows of a recording by instance."""
    rows = {}
    for line in recording.decode().splitlines()[1:]:
        rows.setdefault(int(line.split(',')[0]), []).append(line)
    return rows


if __name__ == '__main__':
    support.run('benchmark_test')
