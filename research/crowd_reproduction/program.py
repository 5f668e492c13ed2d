"""The command line of research/reproduce."""
from crowd_studies.program import Experiment, Program

from . import claims
from .experiments import (ambiguity, crowd_sensitivity, future_work, learning_curves, reward_evaluation, scenarios,
                          sensitivity, sharing)
from .results import TEXTS, plan

REPORTS = {  # of the experiments, in the order of the thesis
    'reward_evaluation': reward_evaluation.report, 'sensitivity': sensitivity.report,
    'crowd_sensitivity': crowd_sensitivity.report, 'ambiguity': ambiguity.report, 'scenarios': scenarios.report,
    'sharing': sharing.report, 'learning_curves': learning_curves.report,
    'future_work': future_work.report, 'claims': claims.report}
main = Program(
    name='reproduce', title='Reproduction of the thesis',
    experiments=[Experiment(name, TEXTS[name]['title'], plan(name), report) for name, report in REPORTS.items()],
    description='Reproduces experiments of the thesis: trains, evaluates, draws the figures, and writes a page with '
                'them.',
    intro='L. Casadiego, Social Crowd Controllers using Reinforcement Learning Methods (UPC, 2014): the experiments as '
          'reproduced by this package.').main
