"""The command line of research/reproduce."""
from crowd_studies.program import Program

from . import experiments

PROGRAM = Program(
    name='reproduce', title='Reproduction of the thesis', experiments=experiments.ALL,
    description='Reproduces experiments of the thesis: trains, evaluates, draws the figures, and writes a page with '
                'them.',
    intro='L. Casadiego, Social Crowd Controllers using Reinforcement Learning Methods (UPC, 2014): the experiments as '
          'reproduced by this package.')
main = PROGRAM.main
