"""The program `graph_faults`."""
import collections
import pathlib
import random
import statistics
import tempfile
import time

import yaml
from crowd_drawing.errors import read_documents
from crowd_experiments.arguments import above_zero, parser_of, positive, whole
from crowd_experiments.interruption import EXIT_FAILED
from crowd_experiments.runs import output_of
from crowd_experiments.tools import find_config
from crowd_launching.nodes import find_program

from .faults import KINDS
from .graph import Graph, Violation, few_agents

EXAMPLE = '''example:
  source .build/devel/setup.bash
  research/graph_faults --faults 1000 --seed 1

Prints a line for each fault: the time from its beginning until ticks go on without misses, the answers missed since,
file descriptors and memory of the controller; at last a table by kind. After each fault all nodes must be alive, ticks
must go on in time, every agent must have had an answer or a counted miss in every tick, no agent may be in contact, and
no node may use many more descriptors, or much more memory, than at first.
Ctrl-C prints the table so far.'''
MORE = 20, 50.0  # descriptors and memory [MB] that a node may use more than after its first fault
HEADER = '{:>5}  {:24} {:>8} {:>8} {:>12} {:>9}'
LINE = '{:5}  {:24} {:8.2f} {:8} {:12} {:9.1f}'


def make_other_table(folder):
    """Returns a file with a Q-table of another state set, with the actions of the package's tables."""
    config = read_documents(find_config() / 'learning' / 'anticipation.yaml')[0]
    config['state_set'] = read_documents(find_config() / 'learning' / 'thesis_nearest.yaml')[0]['state_set']
    config['training']['scenarios'] = [str(find_config() / 'scenarios' / 'circle6.yaml')]
    file, table = folder / 'other.yaml', folder / 'other.txt'
    file.write_text(yaml.safe_dump(config), encoding='utf-8')
    output_of([find_program('train'), file, '--output', table, '--episodes', 1])
    return table


def kinds_for(draw, chosen, count):
    """Returns kinds of faults: at first each of them once, then drawn by their weights."""
    kinds = draw.sample(chosen, len(chosen))
    kinds += draw.choices(chosen, [KINDS[kind][1] for kind in chosen], k=count)
    return kinds[:count]


class Record:
    """What the faults so far have led to."""

    def __init__(self):
        self.rows = collections.defaultdict(list)  # (seconds, misses), by kind
        self.usages = collections.defaultdict(list)  # (descriptors, MB), by name and process of a node

    def add(self, kind, seconds, misses, usages):
        """Raises Violation if a node uses many more descriptors, or much more memory, than after its first fault."""
        self.rows[kind].append((seconds, misses))
        for node, usage in usages.items():
            self.usages[node].append(usage)
            if any(now > first + more for now, first, more in zip(usage, self.usages[node][0], MORE)):
                raise Violation(f'{node[0]}: descriptors and memory [MB] were {self.usages[node][0]}, are {usage}')

    def print(self):
        print('\n| fault | number | median [s] | longest [s] | misses |\n|---|---|---|---|---|')
        rows = sorted(self.rows.items()) + [('all', [row for rows in self.rows.values() for row in rows])]
        for kind, entries in rows if self.rows else ():
            seconds = [entry[0] for entry in entries]
            print(f'| {kind} | {len(entries)} | {statistics.median(seconds):.2f} | {max(seconds):.2f} | '
                  f'{sum(entry[1] for entry in entries)} |')
        for name in sorted({name for name, _ in self.usages}):
            life = max((life for (of, _), life in self.usages.items() if of == name), key=len)
            (files, memory), (last_files, last_memory) = life[0], life[-1]
            print(f'{name}, longest life of {len(life)} faults: {files} file descriptors at first, {last_files} at '
                  f'last; memory {memory:.1f} MB at first, {last_memory:.1f} MB at last')


def apply(graph, kind, draw):
    """Applies a fault. Returns the time until ticks go on without misses [s], and the misses."""
    missed, ticks, begin = graph.status.missed_answers, graph.status.tick, time.monotonic()
    KINDS[kind][0](graph, draw)
    graph.wait_until_steady()
    status = graph.status
    return time.monotonic() - begin, status.missed_answers - (missed if status.tick > ticks else 0)


def apply_all(arguments, record):
    draw = random.Random(arguments.seed)
    with tempfile.TemporaryDirectory(prefix='social_crowd_') as folder:
        table = make_other_table(pathlib.Path(folder))
        with Graph(folder, arguments.deadline, few_agents(), answer_deadline=arguments.answer_deadline) as graph:
            graph.other_table = table
            graph.start_learners()
            graph.wait_until_steady()
            print(HEADER.format('', 'fault', 'time [s]', 'misses', 'descriptors', 'MB'))
            for number, kind in enumerate(kinds_for(draw, arguments.kinds, arguments.faults)):
                try:
                    seconds, misses = apply(graph, kind, draw)
                    usages = graph.usages()
                    record.add(kind, seconds, misses, usages)
                except Violation as error:
                    raise Violation(f'fault {number}, {kind}, seed {arguments.seed}: {error}') from None
                controller, = (usage for (name, _), usage in usages.items() if name == 'controller')
                print(LINE.format(number, kind, seconds, misses, *controller), flush=True)


def main(words=None):
    parser = parser_of('graph_faults', 'Applies faults to a running crowd controller with learners, one after the '
                       'other, and checks that the crowd goes on.', EXAMPLE)
    add = parser.add_argument
    add('--faults', type=positive, default=100, metavar='N', help='number of faults (default: %(default)s)')
    add('--seed', type=whole, default=1, help='of kinds and times (default: %(default)s)')
    add('--deadline', type=above_zero, default=60.0, metavar='SECONDS',
        help='for ticks to go on, and for nodes to end (default: %(default)s)')
    add('--answer-deadline', type=above_zero, default=0.2, metavar='SECONDS',
        help='of the controller (default: %(default)s)')
    add('--kinds', nargs='+', choices=KINDS, default=list(KINDS), metavar='KIND', help=f'of {", ".join(KINDS)}')
    arguments, record = parser.parse_args(words), Record()
    print(f'seed {arguments.seed}', flush=True)
    try:
        apply_all(arguments, record)
    except Violation as error:
        print(error)
        return EXIT_FAILED
    finally:
        record.print()
    return 0
