"""The claims of chapters 3-5 of the thesis, judged by the results of the other experiments. Has no runs of its own."""
import pathlib

import yaml
from crowd_experiments.pages import Chapter

from . import crowd_judges, knowledge_judges, reward_judges, twins_judges
from .claim import RULE, Claim, add_claims, all_of
from .experiments import ambiguity, future_work, learning_curves, reward_evaluation, scenarios, sharing

NAME = 'claims'
TITLE = 'Claims of the thesis'
FILE = pathlib.Path(__file__).with_name('claims.yaml')
LISTS = yaml.safe_load(FILE.read_text(encoding='utf-8'))
JUDGES = {**vars(crowd_judges), **vars(knowledge_judges), **vars(twins_judges), **vars(reward_judges)}
NEEDS = (reward_evaluation, ambiguity, scenarios, sharing, learning_curves, future_work)  # whose results judges read


def claims_of(name):
    """Returns the Claims of a list of the file."""
    return [Claim(entry['section'], entry['says'],
                  all_of([(JUDGES[judge], words) for judge, *words in entry['judges']]), entry.get('reasons', {}))
            for entry in LISTS[name]['claims']]


def plan(setting):
    """Returns the runs of the experiments whose results the judges read."""
    return [run for experiment in NEEDS for run in experiment.plan(setting)]


def report(setting):
    """Returns the chapter, from the records of the other chapters' runs."""
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(f"{RULE} The thesis's parameters are used unless stated otherwise. Numbers are mean ± standard "
                     'deviation over the seeds (lowest-highest).')
    for name, claims in LISTS.items():
        add_claims(chapter, claims['title'], claims_of(name), setting, name)
    return chapter
