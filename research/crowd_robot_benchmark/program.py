"""research/robot_benchmark: runs of `evaluate`, and records of robots that were driven elsewhere."""
import argparse
import pathlib
import shutil
import typing

import pandas
import yaml
from crowd_drawing.errors import read_documents
from crowd_experiments.arguments import add_file, add_tools, parser_of, positive
from crowd_experiments.pages import fill_document
from crowd_experiments.runs import Run, RunError, execute_left
from crowd_experiments.tools import REPOSITORY, find_config, find_evaluation
from crowd_robots.driving import DRIVEN

from .measures import (CROWDNAV, CROWDNAV_EPISODES, CROWDNAV_KEYS, PLACEMENTS, ROBOTS, ROS_PLACEMENTS, SCENARIOS,
                       VISIBLE, chapter_of, read_record)

RECORD = 'robots.csv'  # in a run's folder
DRIVER = REPOSITORY / 'scripts' / 'drive_robots'
DESCRIPTION = '''Measures robots among people: success, contacts by cause, time, discomfort, and what they cost people,
in the shipped scenarios and in the setting of CrowdNav. Shares have 95 % intervals.'''
EXAMPLES = '''examples:
  research/robot_benchmark                                 all robots that `evaluate` drives, in all scenarios
  research/robot_benchmark --robot learned --scenarios robot_door robot_queue
  research/robot_benchmark --robot move_base --robot move_base_people   through ROS, where move_base is
  research/robot_benchmark --robot other=episodes.csv      adds a robot that was driven elsewhere
  research/robot_benchmark --table                         the tables of the results so far, without running anything
  research/robot_benchmark --document research/docs/robots.md  also updates the tables of the page

A record of a robot that was driven elsewhere has the columns of `evaluate --robots-csv`, and one row an episode. Its
rows belong to the scenario that the column `scenario` names; people_compared is 0 where people's delay is not known.
It is kept in the output folder, and is part of later tables.

Completed runs are kept unless the program, the Q-table or their scenario has changed. Ctrl-C keeps the finished runs;
the same command continues from there.'''


class Benchmark(typing.NamedTuple):
    """The tool, the Q-table of the people, and the folder of all results."""
    evaluate: pathlib.Path
    q_table: pathlib.Path
    scenarios: pathlib.Path  # folder of the scenario files
    output: pathlib.Path
    placements: int
    ros_placements: int  # of robots that are driven through ROS
    crowdnav_episodes: int

    def run_of(self, robot, scenario):
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
        document = read_documents(file)[0]
        for robot in document['robots']:
            robot.update(keys)
        if 'map' in document:
            document['map'] = str((self.scenarios / document['map']).resolve())
        folder = '_'.join(f'{key}_{value}' for key, value in keys.items()).lower()
        copy = self.output / 'scenarios' / folder / f'{name}.yaml'
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(yaml.safe_dump(document, sort_keys=False), encoding='utf-8')
        return copy


def wanted_robot(text):
    """Reads NAME or NAME=FILE. Returns name and file, or None."""
    name, equals, file = text.partition('=')
    is_known = name in (*ROBOTS, *DRIVEN)
    if is_known != bool(equals) and bool(name and file) == bool(equals):
        return name, pathlib.Path(file) if equals else None
    names = ', '.join((*ROBOTS, *DRIVEN))
    raise argparse.ArgumentTypeError(f"expected {names}, or NAME=FILE.csv with another name, got '{text}'")


def main(words=None):
    parser = parser_of('robot_benchmark', DESCRIPTION, EXAMPLES)
    add = parser.add_argument
    add('--robot', type=wanted_robot, action='append', dest='robots', metavar='NAME[=FILE.csv]',
        help=f'{", ".join(ROBOTS)}; {", ".join(DRIVEN)} (through ROS); or a robot that was driven elsewhere and its '
             'record; may be given several times (default: those not through ROS)')
    add('--scenarios', nargs='+', choices=SCENARIOS, default=SCENARIOS, metavar='NAME',
        help=f'of {", ".join(SCENARIOS)} (default: all)')
    add('--placements', type=positive, default=PLACEMENTS, metavar='N',
        help='episodes of each scenario (default: %(default)s)')
    add('--ros-placements', type=positive, default=ROS_PLACEMENTS, metavar='N',
        help='the same for robots that are driven through ROS (default: %(default)s)')
    add('--crowdnav-episodes', type=int, default=CROWDNAV_EPISODES, metavar='N',
        help="episodes in CrowdNav's setting; 0: leave it out (default: %(default)s)")
    add('--table', action='store_true', help='print the tables of stored results; runs nothing')
    add_file(parser, '--output', default=pathlib.Path('results/robots'), metavar='FOLDER',
             help='folder of all results (default: %(default)s)')
    add_file(parser, '--document', metavar='FILE.md', help='also update the tables of this document')
    add_file(parser, '--q-table', help='Q-table of people and of the learned robot (default: anticipation)')
    add('--processes', type=positive, default=1, metavar='N', help='number of parallel runs (default: %(default)s)')
    add_tools(parser, 'evaluate')
    arguments = parser.parse_args(words)
    evaluate, q_table = find_evaluation(arguments)
    benchmark = Benchmark(evaluate, q_table, find_config() / 'scenarios', arguments.output.absolute(),
                          arguments.placements, arguments.ros_placements, arguments.crowdnav_episodes)
    if not arguments.table:
        carry_out(benchmark, arguments)
    report(benchmark, arguments.document)


def carry_out(benchmark, arguments):
    robots = dict(arguments.robots or [(name, None) for name in ROBOTS])
    for robot, file in robots.items():
        if file:  # of a robot that was driven elsewhere
            read_record(file)
            kept = benchmark.output / 'others' / f'{robot}.csv'
            kept.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, kept)
    runs = [run for robot, file in robots.items() if not file
            for run in [*(benchmark.run_of(robot, scenario) for scenario in arguments.scenarios),
                        *benchmark.crowdnav_runs(robot).values()]]
    execute_left(runs, arguments.processes)


def report(benchmark, document):
    records, crowdnav = {}, {}
    for robot in (*ROBOTS, *DRIVEN):
        done = [run for run in (benchmark.run_of(robot, name) for name in SCENARIOS) if run.is_done()]
        if done:
            records[robot] = pandas.concat([read_record(run.folder / RECORD) for run in done])
        crowdnav.update({(robot, kind): read_record(run.folder / RECORD)
                         for kind, run in benchmark.crowdnav_runs(robot).items() if run.is_done()})
    records.update({file.stem: read_record(file) for file in sorted((benchmark.output / 'others').glob('*.csv'))})
    chapter = chapter_of(records, SCENARIOS, crowdnav)
    if not chapter.tables():
        raise RunError(f'{benchmark.output}: has no results')
    for table in chapter.tables():
        table.print()
    if document:
        print('\n'.join(fill_document(document, [chapter])))
