"""research/robot_benchmark: runs of `evaluate`, and records of robots that were driven elsewhere."""
import argparse
import pathlib
import shutil
import sys
import tempfile

import pandas
from crowd_experiments.arguments import add_file, add_tools, parser_of, positive, whole
from crowd_experiments.pages import fill_document, write_page
from crowd_experiments.runs import RunError, execute_left
from crowd_experiments.tools import find_config, find_evaluation
from crowd_robots.driving import DRIVEN

from . import verify
from .identity import Inputs
from .measures import chapter_of, read_record
from .results import read_results, write_results
from .suite import CROWDNAV_EPISODES, EPISODES, RECORD, ROBOTS, ROS_EPISODES, Suite, scene_files
from .worst import worst_chapter

RESULTS = 'results.csv'  # in the output folder
FILMS = 2
DESCRIPTION = '''Measures robots among people: success, contacts by cause, time, discomfort, and what they cost people,
in the scenes of config/scenarios/robots and in the setting of CrowdNav. Shares have 95 % intervals.'''
EXAMPLES = '''examples:
  research/robot_benchmark                                 all robots that `evaluate` drives, in all scenes
  research/robot_benchmark --robot learned --scenes robot_door robot_queue
  research/robot_benchmark --robot move_base --robot move_base_people   through ROS, where move_base is
  research/robot_benchmark --robot other=episodes.csv      adds a robot that was driven elsewhere
  research/robot_benchmark --table                         the tables of the results so far, without running anything
  research/robot_benchmark --table --page robots.html      also a page with films of the worst episodes
  research/robot_benchmark --document research/docs/robots.md  also updates the tables of the page
  research/robot_benchmark verify results/robots/results.csv   repeats rows of a results file, see verify --help

The results of `evaluate` are written to results.csv in the output folder: a row for each episode, with a hash of all
that determines it. The same scenes, Q-table and program give the same file on every machine.

A record of a robot that was driven elsewhere has the columns of `evaluate --robots-csv`, and one row an episode. Its
rows belong to the scene that the column `scenario` names; people_compared is 0 where people's delay is not known.
It is kept in the output folder, and is part of later tables.

Completed runs are kept unless the program, the Q-table, their scene or a file that it names has changed. Ctrl-C keeps
the finished runs; the same command continues from there.'''


def wanted_robot(text):
    """Reads NAME or NAME=FILE. Returns name and file, or None."""
    name, equals, file = text.partition('=')
    is_known = name in (*ROBOTS, *DRIVEN)
    if is_known != bool(equals) and bool(name and file) == bool(equals):
        return name, pathlib.Path(file) if equals else None
    names = ', '.join((*ROBOTS, *DRIVEN))
    raise argparse.ArgumentTypeError(f"expected {names}, or NAME=FILE.csv with another name, got '{text}'")


def parser_for(scenes):
    parser = parser_of('robot_benchmark', DESCRIPTION, EXAMPLES)
    add = parser.add_argument
    add('--robot', type=wanted_robot, action='append', dest='robots', metavar='NAME[=FILE.csv]',
        help=f'{", ".join(ROBOTS)}; {", ".join(DRIVEN)} (through ROS); or a robot that was driven elsewhere and its '
             'record; may be given several times (default: those not through ROS)')
    add('--scenes', nargs='+', choices=scenes, default=list(scenes), metavar='NAME',
        help=f'of {", ".join(scenes)} (default: all)')
    add('--episodes', type=positive, default=EPISODES, metavar='N',
        help='episodes of each scene, each with placements of its own (default: %(default)s)')
    add('--ros-episodes', type=positive, default=ROS_EPISODES, metavar='N',
        help='the same for robots that are driven through ROS (default: %(default)s)')
    add('--crowdnav-episodes', type=int, default=CROWDNAV_EPISODES, metavar='N',
        help="episodes in CrowdNav's setting; 0: leave it out (default: %(default)s)")
    add('--table', action='store_true', help='print the tables of stored results; runs nothing')
    add_file(parser, '--output', default=pathlib.Path('results/robots'), metavar='FOLDER',
             help='folder of all results (default: %(default)s)')
    add_file(parser, '--document', metavar='FILE.md', help='also update the tables of this document')
    add_file(parser, '--page', metavar='FILE.html', help='also write a page with the tables, and the worst episodes of '
             'each robot with films')
    add('--films', type=whole, default=FILMS, metavar='N',
        help='films of each robot on the page (default: %(default)s)')
    add_file(parser, '--q-table', help='Q-table of people and of the learned robot (default: anticipation)')
    add('--processes', type=positive, default=1, metavar='N', help='number of parallel runs (default: %(default)s)')
    add('--threads', type=positive, default=1, metavar='N',
        help='threads of each run; results do not depend on it (default: %(default)s)')
    add_tools(parser, 'evaluate')
    return parser


def main(words=None):
    words = sys.argv[1:] if words is None else words
    if words[:1] == ['verify']:
        return verify.main(words[1:])
    scenes = scene_files(find_config())
    arguments = parser_for(scenes).parse_args(words)
    evaluate, q_table = find_evaluation(arguments)
    suite = Suite(evaluate, q_table, scenes, arguments.output.absolute(), arguments.episodes, arguments.ros_episodes,
                  arguments.crowdnav_episodes, arguments.threads)
    if not arguments.table:
        carry_out(suite, arguments)
    report(suite, arguments)
    return 0


def carry_out(suite, arguments):
    robots = dict(arguments.robots or [(name, None) for name in ROBOTS])
    for robot, file in robots.items():
        if file:  # of a robot that was driven elsewhere
            read_record(file)
            kept = suite.output / 'others' / f'{robot}.csv'
            kept.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, kept)
    runs = [run for robot, file in robots.items() if not file
            for run in [*(suite.run_of(robot, scene) for scene in arguments.scenes),
                        *suite.crowdnav_runs(robot).values()]]
    execute_left(runs, arguments.processes)


def finished_runs(suite):
    """Returns the finished runs by robot, and those in CrowdNav's setting by (robot, VISIBLE or INVISIBLE)."""
    runs, crowdnav = {}, {}
    for robot in (*ROBOTS, *DRIVEN):
        done = [run for run in (suite.run_of(robot, name) for name in suite.scenes) if run.is_done()]
        if done:
            runs[robot] = done
        crowdnav.update({(robot, kind): run for kind, run in suite.crowdnav_runs(robot).items() if run.is_done()})
    return runs, crowdnav


def report(suite, arguments):
    """Prints the tables and writes the results file; also a document and a page, as far as they are wanted."""
    runs, crowdnav = finished_runs(suite)
    records = {robot: pandas.concat([read_record(run.folder / RECORD) for run in done]) for robot, done in runs.items()}
    records.update({file.stem: read_record(file) for file in sorted((suite.output / 'others').glob('*.csv'))})
    chapter = chapter_of(records, suite.scenes,
                         {key: read_record(run.folder / RECORD) for key, run in crowdnav.items()})
    if not chapter.tables():
        raise RunError(f'{suite.output}: has no results')
    for table in chapter.tables():
        table.print()
    if arguments.document:
        print('\n'.join(fill_document(arguments.document, [chapter])))
    intro = 'Rows of robots through ROS, or driven elsewhere, cannot be repeated.'
    chapters = [chapter]
    repeatable = [robot for robot in runs if robot in ROBOTS]
    if repeatable:
        file = suite.output / RESULTS
        count, digest = write_results(file, suite, Inputs(suite), repeatable)
        intro = f'{count} episodes in {RESULTS}, SHA-256 {digest}'
        print(f'\n{file}: {count} rows, SHA-256 {digest}')
    with tempfile.TemporaryDirectory(prefix='social_crowd_') as folder:
        if arguments.page and repeatable:
            chapters.append(worst_chapter(suite, *read_results(file), arguments.films, pathlib.Path(folder)))
        if arguments.page:
            write_page(arguments.page, 'Robots among people', None, chapters, intro)
            print(f'{arguments.page}: {arguments.page.stat().st_size / 1e6:.1f} MB')
