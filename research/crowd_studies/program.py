"""A program that runs experiments and writes a page with their results; texts of its chapters are in a YAML file."""
import concurrent.futures
import itertools
import os
import pathlib
import re
import time
import typing

import yaml
from crowd_experiments import style
from crowd_experiments.arguments import add_file, add_tools, parser_of, positive
from crowd_experiments.pages import Chapter, fill_document, write_chapters, write_page
from crowd_experiments.runs import RunError, execute_left, text_of
from crowd_experiments.tools import find_config, find_tools
from crowd_experiments.variations import Setting

COUNT = re.compile(r'\{([\d,]+)\|([\d,]+)\}')  # a number, and the one with --quick
EPILOG = '''experiments:
{experiments}  all                all of them

Completed runs are kept unless one of their programs, configurations or scenarios has changed. Ctrl-C keeps the
finished runs; the same command continues from there.

example:
  research/{program.name} {program.experiments[0].name} --results results --processes 2'''


def read_texts(package):
    """Returns the texts of a package, given its __file__, by chapters."""
    return yaml.safe_load(pathlib.Path(package).with_name('texts.yaml').read_text(encoding='utf-8'))


class Report(Chapter):
    """A chapter with a setting. Its texts have names: `title`, and those of texts, figures and tables. In a text,
    {name} stands for a value, and {100|5} for 100, with --quick for 5."""

    def __init__(self, name, texts, setting, **values):
        super().__init__(name, texts[name]['title'])
        self.texts, self.setting, self.values = texts[name], setting, values

    def text_of(self, name, **values):
        text = COUNT.sub(lambda match: str(self.setting.count(*match.groups())), self.texts[name])
        return text.format(**{**self.values, **values})

    def say(self, name, **values):
        self.add_text(self.text_of(name, **values))

    def draw(self, figure, file, text=None, **values):
        """Saves a figure and adds it; its caption has the name of the file, unless another name is given."""
        target = self.setting.results / 'figures' / f'{file}.png'
        self.add_figure(style.save(figure, target), self.text_of(text or file, **values))

    def tabulate(self, name, header, rows, text=None, **values):
        """Adds a table; its title has the name of the table, unless another name is given."""
        self.add_table(self.text_of(text or name, **values), header, rows, name)


class Experiment(typing.NamedTuple):
    """A chapter of the page: functions of the Setting that return its runs, and the chapter from their results."""
    name: str
    title: str
    plan: typing.Callable
    report: typing.Callable


class Program(typing.NamedTuple):
    """Its parameters. `needs_benchmark`: experiments without runs need the steering benchmark."""
    name: str
    title: str  # of the page
    experiments: tuple
    description: str  # for --help
    intro: str  # of the page
    needs_benchmark: bool = False

    def main(self, words=None):
        arguments = self.parser().parse_args(words)
        start = time.monotonic()
        chosen = [experiment for experiment in self.experiments
                  if experiment.name in arguments.experiments or 'all' in arguments.experiments]
        benchmark = arguments.benchmark.resolve() if self.needs_benchmark and arguments.benchmark else None
        if benchmark and not (benchmark / 'reference.csv').is_file():
            raise RunError(f'{benchmark}: has no reference.csv')
        setting = Setting(find_tools(arguments.tools), find_config(), arguments.results.absolute(), arguments.quick,
                          benchmark=benchmark)
        for experiment in chosen:
            if not experiment.plan(setting):
                print(f'{experiment.name}: left out, it needs the steering benchmark (--benchmark FOLDER)', flush=True)
        execute_left([run for experiment in chosen for run in experiment.plan(setting)], arguments.processes,
                     arguments.force)
        chapters = self.chapters(setting, chosen, arguments.processes)
        if arguments.document:
            print('\n'.join(fill_document(arguments.document, chapters)))
        if arguments.pages:
            write_chapters(pathlib.Path(arguments.pages), chapters)
        page = setting.results / 'index.html'
        page.parent.mkdir(parents=True, exist_ok=True)
        write_page(page, self.title, self.name, chapters,
                   self.intro + (' Quick run: the results are meaningless.' if setting.quick else ''))
        print(f'\nTook {text_of(time.monotonic() - start)}. All figures and tables: {page}')

    def parser(self):
        listed = ''.join(f'  {experiment.name:18} {experiment.title}\n' for experiment in self.experiments)
        parser = parser_of(self.name, self.description, EPILOG.format(experiments=listed, program=self))
        parser.add_argument('experiments', nargs='+', choices=[*(one.name for one in self.experiments), 'all'],
                            metavar='EXPERIMENT', help='see below')
        add_file(parser, '--results', default=pathlib.Path('results'), metavar='FOLDER',
                 help='folder of all results (default: results)')
        parser.add_argument('--processes', type=positive, default=min(2, os.cpu_count() or 1), metavar='N',
                            help='number of parallel runs (default: %(default)s)')
        parser.add_argument('--force', action='store_true', help='repeat all runs')
        parser.add_argument('--quick', action='store_true',
                            help='minimal numbers of seeds and episodes, to test the program; results are meaningless')
        add_tools(parser)
        add_file(parser, '--document', metavar='FILE.md',
                 help='also update the tables of this document, and its pictures in images/')
        add_file(parser, '--pages', metavar='FOLDER',
                 help='also write a Markdown page for each experiment, with the pictures that FOLDER/images contains')
        if self.needs_benchmark:
            add_file(parser, '--benchmark', metavar='FOLDER',
                     help='folder of the steering benchmark with scenarios/, reference.csv and score.py; experiments '
                          'that need it are left out without it')
        return parser

    def chapters(self, setting, chosen, processes):
        """Returns the chosen chapters, whose tables it prints, and all others whose runs are complete."""
        planned = [(experiment, experiment.plan(setting)) for experiment in self.experiments]
        complete = [(experiment, runs) for experiment, runs in planned
                    if runs and (experiment in chosen or all(run.is_done() for run in runs))]
        with concurrent.futures.ProcessPoolExecutor(processes) as pool:
            reports = [experiment.report for experiment, _ in reversed(complete)]  # the last ones take longest
            chapters = list(pool.map(call, reports, itertools.repeat(setting)))[::-1]
        for chapter, (experiment, runs) in zip(chapters, complete):
            chapter.commands = runs[0].lines()
            file = setting.results / 'tables' / f'{chapter.name}.md'
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(chapter.markdown(), encoding='utf-8')
            if experiment in chosen:
                for table in chapter.tables():
                    table.print()
        return chapters


def call(report, setting):
    """Returns the chapter that a report makes; a function of a module, so that other processes find it."""
    return report(setting)
