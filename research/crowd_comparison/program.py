"""The command line of research/compare."""
from crowd_studies.program import Experiment, Program

from .experiments import ablations, benchmark, crowds, lanes, moving_obstacles
from .models import TEXTS

EXPERIMENTS = {'benchmark': benchmark, 'crowds': crowds, 'moving_obstacles': moving_obstacles, 'lanes': lanes,
               'ablations': ablations}
main = Program(
    name='compare', title='Learned steering, compared',
    experiments=[Experiment(name, TEXTS[name]['title'], module.plan, module.report)
                 for name, module in EXPERIMENTS.items()],
    description='Compares the learned crowds with each other, and with ORCA and social force: trains, evaluates, '
                'draws\nfigures, and writes a page with them.',
    intro='One Q-table per model for all scenarios, a decision every 0.1 s; the state sets of the thesis, the state '
          'set anticipation, ORCA and social force.', needs_benchmark=True).main
