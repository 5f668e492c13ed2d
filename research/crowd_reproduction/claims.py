"""The claims of chapters 3-5 of the thesis, judged by the results of the other experiments. Has no runs of its own."""
import pathlib

import yaml
from crowd_studies.program import Report

from . import crowd_judges, reward_judges, twins
from .claim import Claim, add_claims, all_of
from .results import TEXTS

LISTS = yaml.safe_load(pathlib.Path(__file__).with_suffix('.yaml').read_text(encoding='utf-8'))
JUDGES = {**vars(crowd_judges), **vars(twins), **vars(reward_judges)}


def claims_of(name):
    return [Claim(entry['section'], entry['says'],
                  all_of([(JUDGES[judge], words) for judge, *words in entry['judges']]), entry.get('reasons', {}))
            for entry in LISTS[name]['claims']]


def report(setting):
    chapter = Report('claims', TEXTS, setting)
    chapter.say('intro')
    for name, claims in LISTS.items():
        add_claims(chapter, claims['title'], claims_of(name), setting, name)
    return chapter
