"""Episodes of the benchmark: runs of `evaluate`, and records of robots that were driven elsewhere."""
import dataclasses
import pathlib
import shutil

import yaml
from crowd_experiments.runs import Run
from crowd_experiments.tools import REPOSITORY
from crowd_robots.driving import DRIVEN

from .measures import CROWDNAV, CROWDNAV_KEYS, ROBOTS, VISIBLE, read_record

RECORD = 'robots.csv'  # in a run's folder
DRIVER = REPOSITORY / 'scripts' / 'drive_robots'


@dataclasses.dataclass(frozen=True)
class Benchmark:
    """The tool, the Q-table of the people, and the folder of all results."""
    evaluate: pathlib.Path
    q_table: pathlib.Path
    scenarios: pathlib.Path  # folder of the scenario files
    output: pathlib.Path
    placements: int
    ros_placements: int  # of robots that are driven through ROS
    crowdnav_episodes: int

    def run_of(self, robot, scenario):
        """Returns the run of a robot in a scenario."""
        if robot in DRIVEN:
            command = [DRIVER, '--robot', robot, '--q-table', self.q_table, '--episodes', self.ros_placements,
                       '--robots-csv', RECORD, self.scenario({}, scenario)]
            return Run(self.output / 'runs' / robot / scenario, [command], 10.0 * self.ros_placements)
        return self.run(robot, scenario, scenario, {}, self.placements)

    def crowdnav_runs(self, robot):
        """Returns the runs in CrowdNav's setting, by VISIBLE and INVISIBLE, as far as they make sense for the robot."""
        if robot in DRIVEN or self.crowdnav_episodes <= 0:
            return {}
        return {kind: self.run(robot, f'crowdnav_{kind}', CROWDNAV, keys, self.crowdnav_episodes)
                for kind, keys in CROWDNAV_KEYS.items() if kind == VISIBLE or not ROBOTS[robot][1]}

    def run(self, robot, name, scenario, keys, episodes):
        """Returns the run of a robot in a scenario of which some keys of the robots are changed."""
        controller, own_keys = ROBOTS[robot]
        command = [self.evaluate, '--q-table', self.q_table, '--robot', controller, '--people-delay', '--episodes',
                   episodes, '--threads', 1, '--robots-csv', RECORD, self.scenario({**own_keys, **keys}, scenario)]
        return Run(self.output / 'runs' / robot / name, [command], float(episodes))

    def scenario(self, keys, name):
        """Returns the file of a scenario; writes a copy if keys of its robots change."""
        file = self.scenarios / f'{name}.yaml'
        if not keys:
            return file
        document = yaml.safe_load(file.read_text(encoding='utf-8'))
        for robot in document['robots']:
            robot.update(keys)
        if 'map' in document:
            document['map'] = str((self.scenarios / document['map']).resolve())
        folder = '_'.join(f'{key}_{value}' for key, value in keys.items()).lower()
        copy = self.output / 'scenarios' / folder / f'{name}.yaml'
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(yaml.safe_dump(document, sort_keys=False), encoding='utf-8')
        return copy

    def others(self):
        """Returns the stored records of robots that were driven elsewhere, by their names."""
        return {file.stem: read_record(file) for file in sorted((self.output / 'others').glob('*.csv'))}

    def store(self, robot, file):
        """Checks a record of a robot that was driven elsewhere, and stores it under the robot's name."""
        read_record(file)
        kept = self.output / 'others' / f'{robot}.csv'
        kept.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, kept)
