"""A program that runs experiments and writes a page with their results."""
import argparse
import dataclasses
import os
import pathlib
import signal
import sys
import time

from crowd_experiments.pages import fill_document, write_page
from crowd_experiments.interruption import EXIT_FAILED, EXIT_FINE, EXIT_INTERRUPTED, interrupt
from crowd_experiments.arguments import positive
from crowd_experiments.progress import text_of
from crowd_experiments.runs import RunError, carry_out
from crowd_experiments.setting import Setting
from crowd_experiments.tools import find_config, find_tools


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
                   f'example:\n  research/{self.name} {self.experiments[0].NAME} --results results --processes 2\n\n'
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
            folder = setting.results / 'tables'
            folder.mkdir(parents=True, exist_ok=True)
            (folder / f'{chapter.name}.md').write_text(chapter.markdown(), encoding='utf-8')
            chapters.append(chapter)
            if experiment in chosen:
                for table in chapter.tables():
                    table.print()
        return chapters
