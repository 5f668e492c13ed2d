"""The scenes and robots of the benchmark, and the runs of `evaluate` and scripts/drive_robots that measure them."""
import pathlib
import typing

import yaml
from crowd_drawing.errors import read_documents, replaced
from crowd_experiments.runs import Run
from crowd_experiments.scenario_files import files_named_in
from crowd_experiments.tools import REPOSITORY
from crowd_robots.driving import DRIVEN

from .identity import scene_digest

RECORD = 'robots.csv'  # in a run's folder
DRIVER = REPOSITORY / 'scripts' / 'drive_robots'
SEED = 1  # of the placements; an episode's number is drawn with it
EPISODES = 30  # of each scene
ROS_EPISODES = 3  # the same for robots that are driven through ROS


class Baseline(typing.NamedTuple):
    """A robot that is run here: the controller of `evaluate --robot`, and the keys that change in a scene's robots."""
    controller: str
    keys: dict


ROBOTS = {
    'straight': Baseline('straight', {}),
    'reactive': Baseline('reactive', {}),
    'orca': Baseline('orca', {}),
    'social_force': Baseline('social_force', {}),
    'learned': Baseline('learned', {}),
    'learned_stop': Baseline('learned', {'yields': 'both'}),  # with protective stop
}
# CrowdNav's setting: a circle of 4 m, five people, bodies of 0.3 m, 1 m/s, 25 s.
CROWDNAV = 'robot_circle_5'
CROWDNAV_EPISODES = 500
VISIBLE, INVISIBLE = 'visible', 'invisible'
CROWDNAV_KEYS = {VISIBLE: {}, INVISIBLE: {'perceived': False}}


def scene_files(config):
    """Returns the scenario files of the scenes by their names, in alphabetical order."""
    return {file.stem: file for file in sorted((config / 'scenarios' / 'robots').glob('*.yaml'))}


def changed_scene(file, keys, copy):
    """Returns the file of a scene; with keys, writes the copy in which its robots have them."""
    if not keys:
        return file
    document = read_documents(file)[0]
    for robot in document['robots']:
        robot.update(keys)
    for entry, key in files_named_in(document):
        entry[key] = str((file.parent / entry[key]).resolve())
    text = yaml.safe_dump(document, sort_keys=False)
    if not copy.is_file() or copy.read_text(encoding='utf-8') != text:
        copy.parent.mkdir(parents=True, exist_ok=True)
        with replaced(copy) as part:
            part.write_text(text, encoding='utf-8')
    return copy


class Suite(typing.NamedTuple):
    """The programs, the Q-table of the people, the scenes, and the folder of all results."""
    evaluate: pathlib.Path
    q_table: pathlib.Path
    scenes: dict  # files by their names
    output: pathlib.Path
    episodes: int = EPISODES
    ros_episodes: int = ROS_EPISODES
    crowdnav_episodes: int = CROWDNAV_EPISODES
    threads: int = 1  # of each run

    def run_of(self, robot, scene):
        if robot in DRIVEN:
            command = [DRIVER, '--robot', robot, '--q-table', self.q_table, '--episodes', self.ros_episodes,
                       '--robots-csv', RECORD, self.scenes[scene]]
            return Run(self.output / 'runs' / robot / scene, [command], 10.0 * self.ros_episodes)
        return self.run(robot, scene, scene, {}, self.episodes)

    def crowdnav_runs(self, robot):
        """Returns the runs in CrowdNav's setting, by VISIBLE and INVISIBLE, as far as they make sense for the robot."""
        if robot in DRIVEN or self.crowdnav_episodes <= 0:
            return {}
        return {kind: self.run(robot, f'crowdnav_{kind}', CROWDNAV, keys, self.crowdnav_episodes)
                for kind, keys in CROWDNAV_KEYS.items() if kind == VISIBLE or not ROBOTS[robot].keys}

    def all_runs(self, robot):
        """Yields the keys of the robot that change, the scene and the run, of all runs of a robot of ROBOTS."""
        for scene in self.scenes:
            yield {}, scene, self.run_of(robot, scene)
        for kind, run in self.crowdnav_runs(robot).items():
            yield CROWDNAV_KEYS[kind], CROWDNAV, run

    def run(self, robot, name, scene, keys, episodes):
        """Returns the run of a robot in a scene of which some keys of the robots are changed."""
        baseline = ROBOTS[robot]
        command = self.command(baseline.controller, {**baseline.keys, **keys}, scene, episodes)
        return Run(self.output / 'runs' / robot / name, [command], float(episodes),
                   (scene_digest(self.scenes[scene]),))

    def command(self, controller, keys, scene, episodes, first=0, seed=SEED):
        """Returns the command of `evaluate` for episodes of a scene, from the number `first` on."""
        folder = '_'.join(f'{key}_{value}' for key, value in keys.items()).lower()
        file = changed_scene(self.scenes[scene], keys, self.output / 'scenarios' / folder / f'{scene}.yaml')
        return [self.evaluate, '--q-table', self.q_table, '--robot', controller, '--people-delay', '--seed', seed,
                '--first', first, '--episodes', episodes, '--threads', self.threads, '--robots-csv', RECORD, file]
