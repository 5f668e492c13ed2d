"""The command line of research/compare."""
import pathlib

from crowd_studies.program import Program
from crowd_experiments.tools import find_config, find_tools
from crowd_experiments.runs import RunError

from . import experiments
from .setting import ComparisonSetting


class ComparisonProgram(Program):
    """A program with an optional folder of the steering benchmark."""

    def parser(self):
        parser = super().parser()
        parser.add_argument('--benchmark', type=pathlib.Path, metavar='FOLDER',
                            help='folder of the steering benchmark with scenarios/, reference.csv and score.py; '
                                 'experiments that need it are left out without it')
        return parser

    def setting_of(self, arguments):
        benchmark = arguments.benchmark
        if benchmark and not (benchmark / 'reference.csv').is_file():
            raise RunError(f'{benchmark}: has no reference.csv')
        setting = ComparisonSetting(find_tools(arguments.tools), find_config(), arguments.results.absolute(),
                                    arguments.quick, benchmark=benchmark and benchmark.resolve())
        for experiment in self.experiments:
            if {'all', experiment.NAME} & set(arguments.experiments) and not experiment.plan(setting):
                print(f'{experiment.NAME}: left out, it needs the steering benchmark (--benchmark FOLDER)', flush=True)
        return setting


PROGRAM = ComparisonProgram(
    name='compare', title='Learned steering, compared', experiments=experiments.ALL,
    description='Compares the learned crowds with each other, and with ORCA and social force: trains, evaluates, '
                'draws\nfigures, and writes a page with them.',
    intro='One Q-table per model for all scenarios, a decision every 0.1 s; the state sets of the thesis, the state '
          'set anticipation, ORCA and social force.')
main = PROGRAM.main
