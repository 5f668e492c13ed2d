"""A claim of the thesis, and the rule by which it is decided whether it comes out here."""
import dataclasses
import typing

import numpy

from crowd_experiments.records import spread_text

COMES_OUT, IN_PART, NOT = 'comes out', 'comes out in part', 'does not come out'
LEAST_SHARE = 0.75  # of the seeds that a claim is to hold for
RULE = (
    f'Verdicts are given by a rule. "{COMES_OUT}": it holds for the mean over the seeds and for at least three '
    'quarters of the seeds; where two sides are compared, that is done seed by seed, and their means are to differ by '
    f'more than a standard error of the difference; "{IN_PART}": for one of both only, or for a part of what is '
    f'claimed; "{NOT}": for neither. A tie does not hold. A number of the thesis comes out where our mean is within 5 '
    'points of it and the seeds lie on both sides of it, and in part where one of the two is so.')
NEAR = 5.0  # [points]


@dataclasses.dataclass(frozen=True)
class Judgement:
    """Our numbers, as a text with seeds and spread, and the verdict that they lead to."""
    measured: str
    verdict: str


@dataclasses.dataclass(frozen=True)
class Claim:
    """What the thesis says in a section, and how that is judged."""
    section: str
    says: str  # the thesis's words
    judge: typing.Callable  # of the Setting; returns a Judgement
    reasons: dict = dataclasses.field(default_factory=dict)  # why, by verdict, where it is known

    def row(self, setting):
        """Section, quotation, what was measured, verdict, reason."""
        judgement = self.judge(setting)
        return [self.section, self.says, judgement.measured, judgement.verdict,
                self.reasons.get(judgement.verdict, '')]


def decide(holds_for_mean, holds_for_seeds):
    """The verdict, given whether a claim holds for the mean, and for each of the seeds."""
    holds_for_most = numpy.mean(list(map(bool, holds_for_seeds))) >= LEAST_SHARE
    return (NOT, IN_PART, COMES_OUT)[int(bool(holds_for_mean)) + int(holds_for_most)]


def decide_greater(first, second):
    """The verdict on 'the first is greater than the second', given both for the same seeds."""
    first, second = numpy.array(list(first), dtype=float), numpy.array(list(second), dtype=float)
    return decide(first.mean() - second.mean() > standard_error(first, second), first > second)


def standard_error(first, second):
    """Of the mean of the differences; 0 where one side is infinite for a seed."""
    if len(first) < 2 or not (numpy.isfinite(first).all() and numpy.isfinite(second).all()):
        return 0.0
    return float(numpy.std(first - second, ddof=1)) / len(first) ** 0.5


def decide_each(values, condition):
    """The verdict on 'it fulfils the condition', given a value for each seed."""
    values = list(values)
    return decide(condition(float(numpy.mean(values))), map(condition, values))


def decide_near(values, number):
    """The verdict on a number of the thesis [%]."""
    values = list(values)
    is_near = abs(float(numpy.mean(values)) - number) <= NEAR
    is_among = min(values) <= number <= max(values)
    return (NOT, IN_PART, COMES_OUT)[int(is_near) + int(is_among)]


def decide_all(*verdicts):
    """The verdict on a claim that has parts."""
    if len(set(verdicts)) == 1:
        return verdicts[0]
    return IN_PART


def versus(name, values, other_name, other_values, decimals=2):
    """Two sides with their spread over the seeds, and in how many seeds the first is greater: a text."""
    values, other_values = list(values), list(other_values)
    greater = sum(a > b for a, b in zip(values, other_values))
    return (f'{name} {spread_text(values, decimals)}, {other_name} {spread_text(other_values, decimals)}; '
            f'greater with {name} in {greater} of {len(values)} seeds')


def add_claims(chapter, title, claims, setting, name):
    """The table of claims, and a sentence that counts the verdicts."""
    rows = [claim.row(setting) for claim in claims]
    chapter.add_table(title, ['section', 'the thesis says', 'measured', 'verdict', 'reason, where it is known'], rows,
                      name)
    counts = [f'{sum(row[3] == verdict for row in rows)} {"come out" if verdict == COMES_OUT else verdict}'
              for verdict in (COMES_OUT, IN_PART, NOT)]
    chapter.tell(f'Of {len(rows)} claims {counts[0]}, {counts[1].replace("comes", "come")}, '
                 f'{counts[2].replace("does", "do")}.')
