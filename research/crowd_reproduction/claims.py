"""The claims of chapters 3-5 of the thesis, judged by the results of the other experiments. Has no runs of its own."""
import importlib
import importlib.util

from crowd_experiments.pages import Chapter

from .claim import RULE, add_claims

NAME = 'claims'
TITLE = 'Claims of the thesis'
# Modules with CLAIMS, TITLE, and NEEDS: the experiments whose results the judges read.
LISTS = {'reward_claims': 'rewards', 'crowd_claims': 'crowds'}


def lists():
    """Returns the existing modules, by the names of their tables."""
    return {name: importlib.import_module(f'.{module}', __package__) for module, name in LISTS.items()
            if importlib.util.find_spec(f'.{module}', __package__)}


def plan(setting):
    """Returns the runs of the experiments whose results the judges read."""
    needed = {experiment.NAME: experiment for module in lists().values() for experiment in module.NEEDS}
    return [run for experiment in needed.values() for run in experiment.plan(setting)]


def report(setting):
    """Returns the chapter, from the records of the other chapters' runs."""
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(f"{RULE} The thesis's parameters are used unless stated otherwise. Numbers are mean ± standard "
                     'deviation over the seeds (lowest-highest).')
    for name, module in lists().items():
        add_claims(chapter, module.TITLE, module.CLAIMS, setting, name)
    return chapter
