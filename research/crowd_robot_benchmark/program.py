"""The command line of research/robot_benchmark."""
import argparse
import pathlib

import pandas
from crowd_experiments.arguments import add_file, add_tools, parser_of, positive
from crowd_experiments.pages import fill_document
from crowd_experiments.runs import RunError, execute_left
from crowd_experiments.tools import find_config, find_evaluation
from crowd_robots.driving import DRIVEN

from .measures import CROWDNAV_EPISODES, PLACEMENTS, ROBOTS, ROS_PLACEMENTS, SCENARIOS, chapter_of, read_record
from .runs import RECORD, Benchmark

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
the same command continues from there.

Exit status: 0 success, 1 a run failed or an input is wrong, 2 wrong usage, 130 interrupted.'''


def wanted_robot(text):
    """Reads NAME or NAME=FILE. Returns name and file, or None."""
    name, equals, file = text.partition('=')
    is_known = name in (*ROBOTS, *DRIVEN)
    if is_known != bool(equals) and bool(name and file) == bool(equals):
        return name, pathlib.Path(file) if equals else None
    names = ', '.join((*ROBOTS, *DRIVEN))
    raise argparse.ArgumentTypeError(f"expected {names}, or NAME=FILE.csv with another name, got '{text}'")


def parser():
    """Returns the parser of the command line."""
    found = parser_of('robot_benchmark', DESCRIPTION, EXAMPLES)
    add = found.add_argument
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
    add_file(found, '--output', default=pathlib.Path('results/robots'), metavar='FOLDER',
             help='folder of all results (default: %(default)s)')
    add_file(found, '--document', metavar='FILE.md', help='also update the tables of this document')
    add_file(found, '--q-table', help='Q-table of people and of the learned robot (default: anticipation)')
    add('--processes', type=positive, default=1, metavar='N', help='number of parallel runs (default: %(default)s)')
    add_tools(found, 'evaluate')
    return found


def main(words=None):
    """Runs the program with command line words."""
    arguments = parser().parse_args(words)
    evaluate, q_table = find_evaluation(arguments)
    benchmark = Benchmark(evaluate, q_table, find_config() / 'scenarios', arguments.output.absolute(),
                          arguments.placements, arguments.ros_placements, arguments.crowdnav_episodes)
    if not arguments.table:
        carry_out(benchmark, arguments)
    report(benchmark, arguments.document)


def carry_out(benchmark, arguments):
    """Stores the given records, and executes the runs that are not done yet."""
    robots = dict(arguments.robots or [(name, None) for name in ROBOTS])
    for robot, file in robots.items():
        if file:
            benchmark.store(robot, file)
    runs = [run for robot, file in robots.items() if not file
            for run in [*(benchmark.run_of(robot, scenario) for scenario in arguments.scenarios),
                        *benchmark.crowdnav_runs(robot).values()]]
    execute_left(runs, arguments.processes)


def report(benchmark, document):
    """Prints the tables of all stored results, and updates the document."""
    records, crowdnav = {}, {}
    for robot in (*ROBOTS, *DRIVEN):
        done = [run for run in (benchmark.run_of(robot, name) for name in SCENARIOS) if run.is_done()]
        if done:
            records[robot] = pandas.concat([read_record(run.folder / RECORD) for run in done])
        crowdnav.update({(robot, kind): read_record(run.folder / RECORD)
                         for kind, run in benchmark.crowdnav_runs(robot).items() if run.is_done()})
    records.update(benchmark.others())
    chapter = chapter_of(records, SCENARIOS, crowdnav)
    if not chapter.tables():
        raise RunError(f'{benchmark.output}: has no results')
    for table in chapter.tables():
        table.print()
    if document:
        print('\n'.join(fill_document(document, [chapter])))
