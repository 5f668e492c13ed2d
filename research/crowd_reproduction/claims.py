"""The claims of chapters 3-5 of the thesis, judged by the results of the other experiments. Has no runs of its own."""
import pathlib

import yaml
from crowd_studies.program import Report

from . import crowd_judges, reward_judges, twins
from .claim import Claim, VERDICTS, all_of
from .results import LEAD, READINGS, Reading, TEXTS

LISTS = yaml.safe_load(pathlib.Path(__file__).with_suffix('.yaml').read_text(encoding='utf-8'))
JUDGES = {**vars(crowd_judges), **vars(twins), **vars(reward_judges)}
SHORT = dict(zip(VERDICTS, ('confirmed', 'partly', 'not')))


def claims_of(name):
    return [Claim(entry['section'], entry['says'],
                  all_of([(JUDGES[judge], words) for judge, *words in entry['judges']]), entry.get('reasons', {}),
                  entry.get('readings', True))
            for entry in LISTS[name]['claims']]


def judge(setting, claims):
    """Returns the Judgements on claims, a list for each reading. Where readings do not differ, that of the first."""
    found = {LEAD: [claim.judge(setting) for claim in claims]}
    for reading in list(READINGS)[1:]:
        other = Reading.of(setting, reading)
        found[reading] = [claim.judge(other) if claim.has_readings else first
                          for claim, first in zip(claims, found[LEAD])]
    return found


def report(setting):
    chapter = Report('claims', TEXTS, setting)
    chapter.say('intro')
    verdicts = {reading: [] for reading in READINGS}
    for name, listed in LISTS.items():
        claims = claims_of(name)
        found = judge(setting, claims)
        for reading, judgements in found.items():
            verdicts[reading] += [judgement.verdict for judgement in judgements]
        add_claims(chapter, listed['title'], claims, found, name)
    chapter.phrases['tally'] = tally_text(verdicts[LEAD])
    chapter.tabulate('tally', ['reading', *VERDICTS], [
        [READINGS[reading]['label'], *(str(given.count(verdict)) for verdict in VERDICTS)]
        for reading, given in verdicts.items()])
    return chapter


def tally_text(verdicts):
    counts = ', '.join(f'{verdicts.count(verdict)} are {verdict}' for verdict in VERDICTS)
    return f'Of {len(verdicts)} claims of the thesis, {counts}.'


def add_claims(chapter, title, claims, found, name):
    """Adds the table of claims, one number each, and a table of all that was measured."""
    others = list(READINGS)[1:]
    chapter.add_table(title, ['section', 'claim of the thesis', 'verdict', 'number', 'with other readings'], [
        [claim.section, claim.says, first.verdict, first.number, readings_text(first, others, found, place)]
        for place, (claim, first) in enumerate(zip(claims, found[LEAD]))], name)
    chapter.add_table(f'{title}: measured', ['section', 'claim of the thesis', 'measured', 'reason, if known', *(
        READINGS[reading]['label'] for reading in others)], [
            [claim.section, claim.says, first.measured, claim.reasons.get(first.verdict, ''), *(
                f'{SHORT[of_reading.verdict]}: {of_reading.number}' if claim.has_readings else ''
                for of_reading in (found[reading][place] for reading in others))]
            for place, (claim, first) in enumerate(zip(claims, found[LEAD]))], f'{name}_measured')


def readings_text(first, others, found, place):
    """Returns the readings with another verdict, or `the same`."""
    parts = []
    for verdict in VERDICTS:
        names = [READINGS[reading]['label'] for reading in others if found[reading][place].verdict == verdict]
        if verdict != first.verdict and names:
            parts.append(f'{SHORT[verdict]}: {"; ".join(names)}')
    return '. '.join(parts) or 'the same'
