"""The claims of chapters 3-5 of the thesis, judged by the results of the other experiments. Has no runs of its own."""
import pathlib

from crowd_drawing.errors import read_documents
from crowd_studies.program import Report

from . import crowd_judges, reward_judges, twins
from .claim import Claim, NOT_CONFIRMED, VERDICTS, all_of
from .declared import LEAD, READINGS, Reading
from .results import TEXTS

DECLARED = read_documents(pathlib.Path(__file__).with_suffix('.yaml'))[0]
JUDGES = {**vars(crowd_judges), **vars(twins), **vars(reward_judges)}
SHORT = dict(zip(VERDICTS, ('confirmed', 'partly', 'not')))
OTHERS = list(READINGS)[1:]


def claims_of(entries):
    return [Claim(entry['section'], entry['says'],
                  all_of([(JUDGES[judge], words) for judge, *words in entry['judges']]), entry.get('reasons', {}),
                  entry.get('readings')) for entry in entries]


def judge(setting, claims):
    """Returns the Judgements on claims, a list for each reading; None where a claim is not judged under a reading."""
    return {reading: [claim.judge(Reading.of(setting, reading)) if reading in (claim.readings or READINGS) else None
                      for claim in claims] for reading in READINGS}


def report(setting):
    chapter = Report('claims', TEXTS, setting)
    chapter.say('intro')
    claims = claims_of(DECLARED)
    add_claims(chapter, claims, judge(setting, claims))
    return chapter


def add_claims(chapter, claims, found):
    """Adds the tables of verdicts with one number each, and of all that was measured; and phrases for the page."""
    rows = list(zip(claims, *found.values()))
    chapter.tabulate('tally', ['reading', *VERDICTS], [
        [READINGS[reading]['label'], *map(str, counts_of(judgements))]
        for reading, judgements in zip(found, zip(*(row for _, *row in rows if None not in row)))])
    verdict = f"verdict ({READINGS[LEAD]['label']})"
    chapter.tabulate('verdicts', ['section', 'claim of the thesis', verdict, 'number', 'with other readings'], [
        [claim.section, claim.says, first.verdict, first.number, readings_text(first, others)]
        for claim, first, *others in rows])
    chapter.tabulate('measured', ['section', 'claim of the thesis', 'measured', 'reason, if known', *(
        READINGS[reading]['label'] for reading in OTHERS)], [
            [claim.section, claim.says, first.measured, claim.reasons.get(first.verdict, ''), *(
                f'{SHORT[other.verdict]}: {other.number}' if other else 'not measured' for other in others)]
            for claim, first, *others in rows])
    counts = ', '.join(f'{count} {verdict}' for verdict, count in zip(VERDICTS, counts_of(found[LEAD])))
    never = [f'{claim.says} ({claim.section})' for claim, *judgements in rows
             if all(judgement and judgement.verdict == NOT_CONFIRMED for judgement in judgements)]
    chapter.phrases['tally'] = f'Of {len(claims)} claims and expectations of the thesis: {counts}.'
    chapter.phrases['never'] = ''.join(f'\n- {text}' for text in never) + '\n'


def counts_of(judgements):
    return [sum(judgement.verdict == verdict for judgement in judgements) for verdict in VERDICTS]


def readings_text(first, others):
    """Returns the readings with another verdict, or `the same`, and those under which a claim is not judged."""
    verdicts = [other.verdict if other else None for other in others]

    def names(verdict):
        return '; '.join(READINGS[reading]['label'] for reading, found in zip(OTHERS, verdicts) if found == verdict)
    parts = [f'{SHORT[verdict]}: {names(verdict)}' for verdict in VERDICTS
             if verdict != first.verdict and names(verdict)] or ['the same']
    return '. '.join(parts + ([f'not measured: {names(None)}'] if names(None) else []))
