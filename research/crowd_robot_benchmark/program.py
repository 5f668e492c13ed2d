"""The command line of research/robot_benchmark."""
import argparse
import dataclasses
import pathlib
import signal
import sys
import typing

from crowd_experiments.pages import fill_document
from crowd_experiments.arguments import positive
from crowd_experiments.interruption import EXIT_FAILED, EXIT_FINE, EXIT_INTERRUPTED, interrupt
from crowd_experiments.tools import find_config, find_tools
from crowd_experiments.runs import RunError, Runner
from crowd_robots.driving import DRIVEN

from .catalogue import CROWDNAV_EPISODES, PLACEMENTS, ROBOTS, ROS_PLACEMENTS, SCENARIOS
from .measures import joined, read_record
from .runs import RECORD, Benchmark
from .tables import chapter_of

EXAMPLES = '''examples:
  research/robot_benchmark                                 all robots that `evaluate` drives, in all scenarios
  research/robot_benchmark --robot learned --scenarios robot_door robot_queue
  research/robot_benchmark --robot move_base --robot move_base_people   through ROS, where move_base is
  research/robot_benchmark --robot other=episodes.csv      adds a robot that was driven elsewhere
  research/robot_benchmark --table                         the tables of the results so far, without running anything
  research/robot_benchmark --document docs/robots.md       also updates the tables of the page

A record of a robot that was driven elsewhere has the columns of `evaluate --robots-csv`, and one row an episode. Its
rows belong to the scenario that the column `scenario` names; people_compared is 0 where people's delay is not known.
It is kept in the output folder, and is part of later tables.

Completed runs are kept unless the program, the Q-table or their scenario has changed. Ctrl-C keeps the finished runs;
the same command continues from there.

Exit status: 0 success, 1 a run failed or an input is wrong, 2 wrong usage, 130 interrupted.'''


@dataclasses.dataclass(frozen=True)
class WantedRobot:
    """One of ROBOTS or DRIVEN, or a robot with a record of its own."""
    name: str
    file: typing.Optional[pathlib.Path] = None


def wanted_robot(text):
    """Reads NAME or NAME=FILE."""
    name, equals, file = text.partition('=')
    if equals and name and file and name not in (*ROBOTS, *DRIVEN):
        return WantedRobot(name, pathlib.Path(file))
    if not equals and name in (*ROBOTS, *DRIVEN):
        return WantedRobot(name)
    names = ', '.join((*ROBOTS, *DRIVEN))
    raise argparse.ArgumentTypeError(f"expected {names}, or NAME=FILE.csv with another name, got '{text}'")


def parser():
    """Returns the parser of the command line."""
    found = argparse.ArgumentParser(
        prog='robot_benchmark', formatter_class=argparse.RawDescriptionHelpFormatter, epilog=EXAMPLES,
        description='Measures robots among people: success, contacts by cause, time, discomfort, and what they cost '
                    'people, in the\nshipped scenarios and in the setting of CrowdNav. Shares have 95 % intervals.')
    found.add_argument('--robot', type=wanted_robot, action='append', dest='robots', metavar='NAME[=FILE.csv]',
                       help=f'{", ".join(ROBOTS)}; {", ".join(DRIVEN)} (through ROS); or a robot that was driven '
                            'elsewhere and its record; may be given several times (default: those not through ROS)')
    found.add_argument('--scenarios', nargs='+', choices=SCENARIOS, default=SCENARIOS, metavar='NAME',
                       help=f'of {", ".join(SCENARIOS)} (default: all)')
    found.add_argument('--placements', type=positive, default=PLACEMENTS, metavar='N',
                       help='episodes of each scenario (default: %(default)s)')
    found.add_argument('--ros-placements', type=positive, default=ROS_PLACEMENTS, metavar='N',
                       help='the same for robots that are driven through ROS (default: %(default)s)')
    found.add_argument('--crowdnav-episodes', type=int, default=CROWDNAV_EPISODES, metavar='N',
                       help="episodes in CrowdNav's setting; 0: leave it out (default: %(default)s)")
    found.add_argument('--table', action='store_true', help='print the tables of stored results; runs nothing')
    found.add_argument('--output', type=pathlib.Path, default=pathlib.Path('results/robots'), metavar='FOLDER',
                       help='folder of all results (default: %(default)s)')
    found.add_argument('--document', type=pathlib.Path, metavar='FILE.md',
                       help='also update the tables of this document')
    found.add_argument('--q-table', type=pathlib.Path, metavar='FILE',
                       help='Q-table of people and of the learned robot (default: anticipation)')
    found.add_argument('--processes', type=positive, default=1, metavar='N',
                       help='number of parallel runs (default: %(default)s)')
    found.add_argument('--tools', type=pathlib.Path, metavar='FOLDER',
                       help='folder of evaluate (default: the folder of this program; if it is not there, the package '
                            'is built)')
    return found


def main(words=None):
    """Runs the program with command line words. Returns the exit status."""
    arguments = parser().parse_args(words)
    signal.signal(signal.SIGTERM, interrupt)
    try:
        benchmark = benchmark_of(arguments)
        if not arguments.table:
            carry_out(benchmark, arguments)
        report(benchmark, arguments.document)
    except KeyboardInterrupt:
        print(f'Interrupted; the finished runs are kept in {arguments.output}, and the same command continues from '
              'there.')
        return EXIT_INTERRUPTED
    except (RunError, OSError) as error:
        print(f'robot_benchmark: {error}', file=sys.stderr)
        return EXIT_FAILED
    return EXIT_FINE


def benchmark_of(arguments):
    """Returns the benchmark that the arguments describe."""
    q_table = (arguments.q_table or find_config() / 'q_tables' / 'anticipation.txt').absolute()
    if not q_table.is_file():
        raise RunError(f'{q_table}: there is no such Q-table')
    return Benchmark(find_tools(arguments.tools) / 'evaluate', q_table, find_config() / 'scenarios',
                     arguments.output.absolute(), arguments.placements, arguments.ros_placements,
                     arguments.crowdnav_episodes)


def carry_out(benchmark, arguments):
    """Stores the given records, and executes the runs that are not done yet."""
    robots = arguments.robots or [WantedRobot(name) for name in ROBOTS]
    for robot in robots:
        if robot.file:
            benchmark.store(robot.name, robot.file)
    runs = []
    for robot in robots:
        if robot.file:
            continue
        runs += [benchmark.run_of(robot.name, scenario) for scenario in arguments.scenarios]
        if arguments.crowdnav_episodes > 0:
            runs += benchmark.crowdnav_runs(robot.name).values()
    left = [run for run in runs if not run.is_done()]
    print(f'{len(runs)} runs, {len(runs) - len(left)} of them done before', flush=True)
    if left:
        Runner(arguments.processes).carry_out(left)


def report(benchmark, document):
    """Prints the tables of all stored results, and updates the document."""
    records, crowdnav = {}, {}
    for robot in (*ROBOTS, *DRIVEN):
        done = [run for run in (benchmark.run_of(robot, name) for name in SCENARIOS) if run.is_done()]
        if done:
            records[robot] = joined([read_record(run.folder / RECORD) for run in done])
        if benchmark.crowdnav_episodes > 0:
            for kind, run in benchmark.crowdnav_runs(robot).items():
                if run.is_done():
                    crowdnav[robot, kind] = read_record(run.folder / RECORD)
    records.update(benchmark.others())
    chapter = chapter_of(records, SCENARIOS, crowdnav)
    if not chapter.tables():
        raise RunError(f'{benchmark.output}: has no results')
    for table in chapter.tables():
        table.print()
    if document:
        for message in fill_document(document, [chapter]):
            print(message)
