"""The claims of chapters 3-5 beside what was measured in the other chapters; has no runs of its own."""
import importlib
import importlib.util

from crowd_experiments.chapter import Chapter

from .claim import RULE, add_claims

NAME = 'claims'
TITLE = 'The claims of the thesis, one by one'
# Modules with CLAIMS, their TITLE, and the experiments that they are judged by: NEEDS.
LISTS = {'reward_claims': 'rewards', 'crowd_claims': 'crowds'}


def lists():
    """The modules that are there, by the names of their tables."""
    return {name: importlib.import_module(f'.{module}', __package__) for module, name in LISTS.items()
            if importlib.util.find_spec(f'.{module}', __package__)}


def plan(setting):
    """The runs of the chapters that the claims are judged by."""
    needed = {experiment.NAME: experiment for module in lists().values() for experiment in module.NEEDS}
    return [run for experiment in needed.values() for run in experiment.plan(setting)]


def report(setting):
    """The chapter, from the records of the other chapters' runs."""
    chapter = Chapter(NAME, TITLE)
    chapter.tell(f"{RULE} All with the thesis's parameters unless it says otherwise; numbers are mean ± standard "
                 'deviation over the seeds (lowest-highest).')
    for name, module in lists().items():
        add_claims(chapter, module.TITLE, module.CLAIMS, setting, name)
    return chapter
