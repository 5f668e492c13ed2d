"""A program that carries out experiments and writes a page about them."""
import argparse
import dataclasses
import itertools
import os
import pathlib
import signal
import subprocess
import sys
import textwrap
import time

from .document import fill_document
from .page import write_page, write_tables
from .progress import text_of
from .runs import RunError, Runner
from .setting import Setting

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ('train', 'evaluate')
LONGEST_CELL = 80  # [characters] of a printed table
EXIT_FINE, EXIT_FAILED, EXIT_INTERRUPTED = 0, 1, 130


@dataclasses.dataclass(frozen=True)
class Program:
    """What sets one such program apart. An experiment is a module with NAME, TITLE, plan(setting) and report(setting);
    one that plans no run is left out."""
    name: str
    title: str  # of the page
    experiments: tuple
    description: str  # for --help
    intro: str  # of the page

    def main(self, words=None):
        """Returns the exit status."""
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
            print('Interrupted; what is done stays.')
            return EXIT_INTERRUPTED
        except (RunError, OSError) as error:
            print(f'{self.name}: {error}', file=sys.stderr)
            return EXIT_FAILED
        print(f'\nTook {text_of(time.monotonic() - start)}. All figures and tables: {page}')
        return EXIT_FINE

    def parser(self):
        """The command line."""
        described = '\n'.join(f'  {experiment.NAME:18} {experiment.TITLE}' for experiment in self.experiments)
        parser = argparse.ArgumentParser(
            prog=self.name, formatter_class=argparse.RawDescriptionHelpFormatter, description=self.description,
            epilog=f'experiments:\n{described}\n  {"all":18} all of them\n\n'
                   'Runs that were completed before are kept unless what they are made from has changed. Ctrl-C keeps '
                   'the runs\nthat are done; the same command goes on from there.')
        names = [experiment.NAME for experiment in self.experiments]
        parser.add_argument('experiments', nargs='+', choices=[*names, 'all'], metavar='EXPERIMENT', help='see below')
        parser.add_argument('--results', type=pathlib.Path, default=pathlib.Path('results'), metavar='FOLDER',
                            help='where everything goes (default: results)')
        parser.add_argument('--processes', type=positive, default=min(2, os.cpu_count() or 1), metavar='N',
                            help='so many runs at a time (default: %(default)s)')
        parser.add_argument('--force', action='store_true', help='do all runs anew')
        parser.add_argument('--quick', action='store_true',
                            help='tiny numbers that mean nothing, to see that all works')
        parser.add_argument('--tools', type=pathlib.Path, metavar='FOLDER',
                            help='of train and evaluate (default: beside this program; else they are built)')
        parser.add_argument('--document', type=pathlib.Path, metavar='FILE.md',
                            help="also fill this document's tables, and the pictures it shows in images/ beside it")
        return parser

    def parse_arguments(self, words):
        return self.parser().parse_args(words)

    def setting_of(self, arguments):
        return Setting(find_tools(arguments.tools), find_config(), arguments.results.absolute(), arguments.quick)

    def write(self, setting, chapters, arguments):
        """The page, and what the document asks for; returns the page's file."""
        if arguments.document:
            for told in fill_document(arguments.document, chapters):
                print(told)
        page = setting.results / 'index.html'
        write_page(page, self.title, self.name, chapters,
                   self.intro + (' Quick numbers, which mean nothing.' if setting.quick else ''))
        return page

    def chapters(self, setting, chosen):
        """What was asked for, and what else is done: figures are drawn, tables written, those asked for printed."""
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


def positive(text):
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError('expected a number above 0')
    return number


def find_tools(given):
    """The folder of the programs; builds them in a clone where they are not beside this program."""
    folder = given or pathlib.Path(sys.argv[0]).parent
    if all(os.access(folder / tool, os.X_OK) for tool in TOOLS):
        return folder.resolve()
    if given:
        raise RunError(f'{given}: has no train and evaluate')
    print('Building, which takes minutes the first time only', flush=True)
    built = subprocess.run([REPOSITORY / 'scripts' / 'build'], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                           text=True, check=False)
    if built.returncode != 0:
        raise RunError(f'{built.stdout}\nthe package does not build')
    build = os.environ.get('SOCIAL_CROWD_BUILD', REPOSITORY / '.build')
    return pathlib.Path(build).resolve() / 'devel' / 'lib' / 'social_crowd'


def find_config():
    """The folder of scenarios and training configurations, in a clone or where the package is installed."""
    for folder in (REPOSITORY / 'config', REPOSITORY.parent / 'share' / 'social_crowd' / 'config'):
        if (folder / 'experiments').is_dir():
            return folder
    raise RunError(f'{REPOSITORY}: found no config/experiments')


def carry_out(setting, chosen, arguments):
    """Does the runs that are not done yet; those that several experiments need once."""
    runs = list({run.folder: run for experiment in chosen for run in experiment.plan(setting)}.values())
    left = runs if arguments.force else [run for run in runs if not run.is_done()]
    print(f'{len(runs)} runs, {len(runs) - len(left)} of them done before', flush=True)
    if not left:
        return True
    try:
        Runner(arguments.processes).carry_out(left)
    except KeyboardInterrupt:
        done = sum(run.is_done() for run in runs)
        print(f'Interrupted: {done} of {len(runs)} runs are done and stay in {setting.results}; '
              'the same command goes on from there.')
        return False
    return True


def print_table(table):
    """A table for the eye; long texts are broken into lines."""
    rows = [[textwrap.wrap(cell, LONGEST_CELL) for cell in row] for row in (table.header, *table.rows)]
    widths = [max(len(line) for row in rows for line in row[i] or ['']) for i in range(len(table.header))]
    print(f'\n{table.title}')
    for row in rows:
        for line in itertools.zip_longest(*row, fillvalue=''):
            print('  '.join(f'{cell:<{width}}' if i == 0 else f'{cell:>{width}}'
                            for i, (cell, width) in enumerate(zip(line, widths))).rstrip())


def interrupt(_signal, _frame):
    raise KeyboardInterrupt
