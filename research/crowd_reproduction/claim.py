"""A claim of the thesis, and the rule that decides whether our results confirm it."""
import dataclasses
import typing

import numpy

from crowd_experiments.records import spread_text

CONFIRMED, PARTLY, NOT_CONFIRMED = 'confirmed', 'partly confirmed', 'not confirmed'
LEAST_SHARE = 0.75  # of the seeds for which a claim must hold
RULE = (
    f'Verdicts follow a rule. "{CONFIRMED}": the claim holds for the mean over the seeds and for at least three '
    'quarters of the seeds. If a claim compares two values, they are compared for each seed, and their means must '
    f'differ by more than a standard error of the difference. "{PARTLY}": the claim holds for the mean only, for the '
    f'seeds only, or in part. "{NOT_CONFIRMED}": it holds for neither. Equal values do not count as greater. A number '
    f'of the thesis is {CONFIRMED} if our mean is within 5 points of it and the range of the seeds includes it, and '
    f'{PARTLY} if one of these conditions is met.')
NEAR = 5.0  # [points]


@dataclasses.dataclass(frozen=True)
class Judgement:
    """Our numbers, as a text with seeds and spread, and the resulting verdict."""
    measured: str
    verdict: str


@dataclasses.dataclass(frozen=True)
class Claim:
    """A statement of the thesis, and the function that judges it."""
    section: str
    says: str  # quotation or summary of the thesis
    judge: typing.Callable  # takes the Setting, returns a Judgement
    reasons: dict = dataclasses.field(default_factory=dict)  # known reasons, by verdict

    def row(self, setting):
        """Returns section, quotation, measured values, verdict and reason."""
        judgement = self.judge(setting)
        return [self.section, self.says, judgement.measured, judgement.verdict,
                self.reasons.get(judgement.verdict, '')]


def decide(holds_for_mean, holds_for_seeds):
    """Returns the verdict, given whether a claim holds for the mean and for each of the seeds."""
    holds_for_most = numpy.mean(list(map(bool, holds_for_seeds))) >= LEAST_SHARE
    return (NOT_CONFIRMED, PARTLY, CONFIRMED)[int(bool(holds_for_mean)) + int(holds_for_most)]


def decide_greater(first, second):
    """Returns the verdict on 'the first is greater than the second', given both values of the same seeds."""
    first, second = numpy.array(list(first), dtype=float), numpy.array(list(second), dtype=float)
    return decide(first.mean() - second.mean() > standard_error(first, second), first > second)


def standard_error(first, second):
    """Returns the standard error of the mean difference; 0 if a value is infinite."""
    if len(first) < 2 or not (numpy.isfinite(first).all() and numpy.isfinite(second).all()):
        return 0.0
    return float(numpy.std(first - second, ddof=1)) / len(first) ** 0.5


def decide_each(values, condition):
    """Returns the verdict on 'the value meets the condition', given a value for each seed."""
    values = list(values)
    return decide(condition(float(numpy.mean(values))), map(condition, values))


def decide_near(values, number):
    """Returns the verdict on a number of the thesis [%]."""
    values = list(values)
    is_near = abs(float(numpy.mean(values)) - number) <= NEAR
    is_among = min(values) <= number <= max(values)
    return (NOT_CONFIRMED, PARTLY, CONFIRMED)[int(is_near) + int(is_among)]


def decide_all(*verdicts):
    """Returns the verdict on a claim with several parts."""
    if len(set(verdicts)) == 1:
        return verdicts[0]
    return PARTLY


def versus(name, values, other_name, other_values, decimals=2):
    """Returns a text with two values, their spread over the seeds, and the number of seeds in which the first is
    greater."""
    values, other_values = list(values), list(other_values)
    greater = sum(a > b for a, b in zip(values, other_values))
    return (f'{name} {spread_text(values, decimals)}, {other_name} {spread_text(other_values, decimals)}; '
            f'{name} greater in {greater} of {len(values)} seeds')


def add_claims(chapter, title, claims, setting, name):
    """Adds the table of claims, and a sentence with the number of each verdict."""
    rows = [claim.row(setting) for claim in claims]
    chapter.add_table(title, ['section', 'claim of the thesis', 'measured', 'verdict', 'reason, if known'], rows, name)
    counts = [f'{sum(row[3] == verdict for row in rows)} {verdict}' for verdict in (CONFIRMED, PARTLY, NOT_CONFIRMED)]
    chapter.add_text(f'Of {len(rows)} claims: {", ".join(counts)}.')
