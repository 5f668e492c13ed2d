"""The command line of research/compare."""
import dataclasses

from crowd_experiments.arguments import add_file
from crowd_experiments.runs import RunError
from crowd_studies.program import Program

from . import experiments


class ComparisonProgram(Program):
    """A program with an optional folder of the steering benchmark."""

    def parser(self):
        parser = super().parser()
        add_file(parser, '--benchmark', metavar='FOLDER',
                 help='folder of the steering benchmark with scenarios/, reference.csv and score.py; experiments that '
                      'need it are left out without it')
        return parser

    def setting_of(self, arguments):
        benchmark = arguments.benchmark
        if benchmark and not (benchmark / 'reference.csv').is_file():
            raise RunError(f'{benchmark}: has no reference.csv')
        setting = dataclasses.replace(super().setting_of(arguments), benchmark=benchmark and benchmark.resolve())
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
