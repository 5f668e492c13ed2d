"""`robot_benchmark verify FILE`: repeats rows of a results file, and compares them bit for bit."""
import concurrent.futures
import json
import pathlib
import tempfile
import typing

from crowd_experiments.arguments import add_file, add_tools, number_type, parser_of, positive
from crowd_experiments.runs import ProgressBar, RunError, output_of
from crowd_experiments.tools import find_config, find_evaluation

from .identity import Inputs
from .results import read_results, record_rows
from .suite import RECORD, Baseline, Suite, scene_files

INPUTS = ('package', 'program', 'compiler', 'q_table', 'scene')
ROWS = 20
ALL = 'all'
EPILOG = '''examples:
  research/robot_benchmark verify results/robots/results.csv
  research/robot_benchmark verify results/robots/results.csv --rows all --processes 2

Each of the rows is compared with what its hash says of it, then its episode is walked again with the scenario, the
Q-table and the program that are here, and each number has to be the same text. Where the program, its compiler, the C
library, the scenario or the Q-table differs from that of the row, a note says so; it is no failure if the results are
the same.'''

rows_type = number_type(lambda text: text if text == ALL else int(text), lambda rows: rows == ALL or rows >= 1,
                        "a whole number from 1, or 'all'")


def spread(rows, count):
    """Returns this many of the rows, spread evenly from the first to the last one."""
    if count == ALL or count >= len(rows):
        return rows
    return [rows[(2 * i + 1) * len(rows) // (2 * count)] for i in range(count)]


def problems_of_identity(row, inputs):
    """Yields why a row cannot be what it says, and cannot be repeated."""
    identity = row.identity
    if identity.computed_hash() != identity.hash:
        yield f'its hash is {identity.hash}, but what it names has the hash {identity.computed_hash()}'
    if identity.scenario not in inputs.scenes:
        yield 'there is no such scene here'


def other_inputs(row, inputs):
    """Yields what differs between what a row was made with and what is here."""
    identity = row.identity
    here = inputs.identity('', Baseline('', {}), identity.scenario, 0, 0)
    for name in INPUTS:
        if getattr(here, name) != getattr(identity, name):
            yield f'{name} is {getattr(identity, name)} in the file, {getattr(here, name)} here'


def repeat(suite, row):
    """Walks the episode of a row again. Returns the columns and the texts of its record. Raises RunError."""
    identity = row.identity
    with tempfile.TemporaryDirectory(prefix='social_crowd_') as name:
        folder = pathlib.Path(name)  # also of a changed scene, so that no other thread writes it
        try:
            command = suite._replace(output=folder).command(identity.controller, json.loads(identity.keys),
                                                            identity.scenario, 1, int(identity.episode),
                                                            int(identity.seed))
        except (AttributeError, ValueError) as error:
            raise RunError(f'{row.place()}: expected keys as JSON, whole numbers as seed and episode: '
                           f'{error}') from None
        output_of(command, cwd=folder)
        columns, rows = record_rows(folder / RECORD)
    return columns, rows[identity.episode]


def problems_of_values(columns, row, here, repeated):
    """Yields the columns in which a row and its repetition differ."""
    if here != columns:
        yield (f'the record has other columns here: {", ".join(sorted(set(columns) ^ set(here)))}'
               if set(here) != set(columns) else 'the columns of the record have another order here')
        return
    for name, old, new in zip(columns, row.values, repeated):
        if old != new:
            yield f'{name} is {old} in the file, {new} here'


class Outcome(typing.NamedTuple):
    """What the repetition of a row has shown."""
    problems: list  # texts: results that differ, and others
    notes: list  # inputs that differ


def check(suite, inputs, columns, row):
    """Returns the Outcome of a row."""
    problems = list(problems_of_identity(row, inputs))
    if row.identity.scenario not in suite.scenes:
        return Outcome(problems, [])
    here, repeated = repeat(suite, row)
    return Outcome([*problems, *problems_of_values(columns, row, here, repeated)], list(other_inputs(row, inputs)))


def main(words):
    parser = parser_of('robot_benchmark verify', 'Repeats rows of a results file of robot_benchmark, and compares them '
                       'bit for bit.', EPILOG, '0 the results of all rows are the same, even if inputs differ, 1 some '
                       'are not, a hash is not that of its row, or an error, 2 wrong usage, 130 interrupted.')
    add_file(parser, 'results', metavar='FILE.csv')
    parser.add_argument('--rows', type=rows_type, default=ROWS, metavar='N',
                        help='number of rows, spread over the file, or all (default: %(default)s)')
    parser.add_argument('--processes', type=positive, default=1, metavar='N',
                        help='number of parallel runs (default: %(default)s)')
    add_file(parser, '--q-table', help='Q-table of people and of the learned robot (default: anticipation)')
    add_tools(parser, 'evaluate')
    arguments = parser.parse_args(words)
    columns, rows = read_results(arguments.results)
    evaluate, q_table = find_evaluation(arguments)
    chosen = spread(rows, arguments.rows)
    suite = Suite(evaluate, q_table, scene_files(find_config()), pathlib.Path())
    return report(arguments.results, chosen, repeat_all(suite, columns, chosen, arguments.processes))


def repeat_all(suite, columns, rows, processes):
    """Returns the Outcome of each row."""
    inputs = Inputs(suite)
    bar = ProgressBar(len(rows), len(rows), 'rows')
    with concurrent.futures.ThreadPoolExecutor(processes) as pool:
        futures = [pool.submit(check, suite, inputs, columns, row) for row in rows]
        try:
            for future in concurrent.futures.as_completed(futures):
                future.result()
                bar.add(1)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
        finally:
            bar.end()
    return [future.result() for future in futures]


def report(file, rows, outcomes):
    """Prints problems and notes. Returns the exit status."""
    for row, outcome in zip(rows, outcomes):
        for text in [*outcome.problems, *(f'note: {note}' for note in outcome.notes)]:
            print(f'{file}:{row.line}: {row.place()}: {text}')
    same = [outcome for outcome in outcomes if not outcome.problems]
    other = sum(bool(outcome.notes) for outcome in same)
    print(f'{file}: {len(rows)} rows repeated: {len(same)} are the same, bit for bit' +
          (f', {other} of them though inputs differ' if other else ''))
    return 0 if len(same) == len(rows) else 1
