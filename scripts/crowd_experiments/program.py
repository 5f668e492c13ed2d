"""A program that runs experiments and writes a page with their results."""
import argparse
import dataclasses
import itertools
import os
import pathlib
import signal
import sys
import textwrap
import time

from .document import fill_document
from .interruption import EXIT_INTERRUPTED, interrupt
from .numbers import positive
from .page import write_page, write_tables
from .progress import text_of
from .runs import RunError, Runner
from .setting import Setting
from .tools import REPOSITORY, find_tools

LONGEST_CELL = 80  # [characters] of a printed table
EXIT_FINE, EXIT_FAILED = 0, 1


@dataclasses.dataclass(frozen=True)
class Program:
    """The parameters of such a program. An experiment is a module with NAME, TITLE, plan(setting) and report(setting);
    an experiment without runs is skipped."""
    name: str
    title: str  # of the page
    experiments: tuple
    description: str  # for --help
    intro: str  # of the page

    def main(self, words=None):
        """Runs the program with command line words. Returns the exit status."""
        arguments = self.parse_arguments(words)
        signal.signal(signal.SIGTERM, interrupt)
        start = time.monotonic()
        chosen = [experiment for experiment in self.experiments
                  if experiment.NAME in arguments.experiments or 'all' in arguments.experiments]
        try:
            setting = self.setting_of(arguments)
            if not carry_out(setting, chosen, arguments):
                return EXIT_INTERRUPTED
            page = self.write(setting, self.chapters(setting, chosen), arguments)
        except KeyboardInterrupt:
            print('Interrupted; the finished runs are kept.')
            return EXIT_INTERRUPTED
        except (RunError, OSError) as error:
            print(f'{self.name}: {error}', file=sys.stderr)
            return EXIT_FAILED
        print(f'\nTook {text_of(time.monotonic() - start)}. All figures and tables: {page}')
        return EXIT_FINE

    def parser(self):
        """Returns the parser of the command line."""
        described = '\n'.join(f'  {experiment.NAME:18} {experiment.TITLE}' for experiment in self.experiments)
        parser = argparse.ArgumentParser(
            prog=self.name, formatter_class=argparse.RawDescriptionHelpFormatter, description=self.description,
            epilog=f'experiments:\n{described}\n  {"all":18} all of them\n\n'
                   'Completed runs are kept unless one of their programs, configurations or scenarios has changed. '
                   'Ctrl-C keeps the\nfinished runs; the same command continues from there.\n\n'
                   f'example:\n  scripts/{self.name} {self.experiments[0].NAME} --results results --processes 2\n\n'
                   'Exit status: 0 success, 1 an error, 2 wrong usage, 130 interrupted.')
        names = [experiment.NAME for experiment in self.experiments]
        parser.add_argument('experiments', nargs='+', choices=[*names, 'all'], metavar='EXPERIMENT', help='see below')
        parser.add_argument('--results', type=pathlib.Path, default=pathlib.Path('results'), metavar='FOLDER',
                            help='folder of all results (default: results)')
        parser.add_argument('--processes', type=positive, default=min(2, os.cpu_count() or 1), metavar='N',
                            help='number of parallel runs (default: %(default)s)')
        parser.add_argument('--force', action='store_true', help='repeat all runs')
        parser.add_argument('--quick', action='store_true',
                            help='minimal numbers of seeds and episodes, to test the program; results are meaningless')
        parser.add_argument('--tools', type=pathlib.Path, metavar='FOLDER',
                            help='folder of train and evaluate (default: the folder of this program; if they are not '
                                 'there, the package is built)')
        parser.add_argument('--document', type=pathlib.Path, metavar='FILE.md',
                            help='also update the tables of this document, and its pictures in images/')
        return parser

    def parse_arguments(self, words):
        return self.parser().parse_args(words)

    def setting_of(self, arguments):
        return Setting(find_tools(arguments.tools), find_config(), arguments.results.absolute(), arguments.quick)

    def write(self, setting, chapters, arguments):
        """Writes the page and updates the document. Returns the file of the page."""
        if arguments.document:
            for message in fill_document(arguments.document, chapters):
                print(message)
        page = setting.results / 'index.html'
        write_page(page, self.title, self.name, chapters,
                   self.intro + (' Quick run: the results are meaningless.' if setting.quick else ''))
        return page

    def chapters(self, setting, chosen):
        """Returns the chosen chapters, and all other chapters whose runs are complete. Draws figures, writes tables,
        and prints the tables of the chosen chapters."""
        chapters = []
        for experiment in self.experiments:
            runs = experiment.plan(setting)
            if not runs or (experiment not in chosen and not all(run.is_done() for run in runs)):
                continue
            chapter = experiment.report(setting)
            chapter.commands = runs[0].lines()
            write_tables(setting.results / 'tables', chapter)
            chapters.append(chapter)
            if experiment in chosen:
                for table in chapter.tables():
                    print_table(table)
        return chapters


def find_config():
    """Returns the folder of scenarios and training configurations, in a clone or an installed package."""
    for folder in (REPOSITORY / 'config', REPOSITORY.parent / 'share' / 'social_crowd' / 'config'):
        if (folder / 'experiments').is_dir():
            return folder
    raise RunError(f'{REPOSITORY}: found no config/experiments')


def carry_out(setting, chosen, arguments):
    """Executes the runs that are not done yet; runs that several experiments share are executed once. Returns whether
    all were completed."""
    runs = list({run.folder: run for experiment in chosen for run in experiment.plan(setting)}.values())
    left = runs if arguments.force else [run for run in runs if not run.is_done()]
    print(f'{len(runs)} runs, {len(runs) - len(left)} of them done before', flush=True)
    if not left:
        return True
    try:
        Runner(arguments.processes).carry_out(left)
    except KeyboardInterrupt:
        done = sum(run.is_done() for run in runs)
        print(f'Interrupted: {done} of {len(runs)} runs are done and kept in {setting.results}; '
              'the same command continues from there.')
        return False
    return True


def print_table(table):
    """Prints a table; long texts are wrapped."""
    rows = [[textwrap.wrap(cell, LONGEST_CELL) for cell in row] for row in (table.header, *table.rows)]
    widths = [max(len(line) for row in rows for line in row[i] or ['']) for i in range(len(table.header))]
    print(f'\n{table.title}')
    for row in rows:
        for line in itertools.zip_longest(*row, fillvalue=''):
            print('  '.join(f'{cell:<{width}}' if i == 0 else f'{cell:>{width}}'
                            for i, (cell, width) in enumerate(zip(line, widths))).rstrip())
