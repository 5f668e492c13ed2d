"""The requirements (bars) and aims for the anticipation crowd, and whether they are met."""
from .metrics_csv import EXCLUDED, greatest, judged, least, not_slower, time_against

HEADER = ['metric', 'bar', 'seed 1', 'worst seed', 'bar met by', 'aim', 'aim met by']


class Bar:
    """An upper or lower limit of a metric, and a stricter limit as an aim; either may be None."""

    def __init__(self, label, measure, bar, aim, decimals=2, at_least=False):
        self.label, self.measure, self.bar, self.aim = label, measure, bar, aim
        self.decimals, self.at_least = decimals, at_least

    def row(self, seeds):
        """Returns the cells of a row: the values of the seeds' metrics, compared with bar and aim."""
        values = [self.measure(metrics) for metrics in seeds]
        worst = min(values) if self.at_least else max(values)
        return [self.label, self.limit(self.bar), self.text(values[0]), self.text(worst), self.met(values, self.bar),
                self.limit(self.aim), self.met(values, self.aim)]

    def text(self, value):
        return f'{value:.{self.decimals}f}'

    def limit(self, limit):
        if limit is None:
            return ''
        return f"{'≥' if self.at_least else '≤'} {limit:.{self.decimals}f}"

    def met(self, values, limit):
        """Returns a text with the number of seeds that meet a limit."""
        if limit is None:
            return ''
        slack = 1e-9  # rounding error of floating-point sums, far below the printed precision
        count = sum(value >= limit - slack if self.at_least else value <= limit + slack for value in values)
        return {len(values): 'all seeds', 0: 'none'}.get(count, f'{count} of {len(values)}')


def rows(seeds, orca, seconds):
    """Returns a row for each bar.
    @param seeds metrics of each training seed, seed 1 first
    @param orca metrics that time, path and turning are compared with
    @param seconds processor time of each training [s]"""
    scenarios = judged(orca)
    bars = [
        Bar('contact %, worst scenario', lambda f: greatest(f, 'contact_pct'), 0, 0),
        Bar(f'clean %, worst scenario without {EXCLUDED}', lambda f: least(f, 'clean_pct', scenarios), 100, 100, 0,
            at_least=True),
        Bar('clean %, worst scenario', lambda f: least(f, 'clean_pct'), None, 100, 0, at_least=True),
        Bar(f'clean %, mean without {EXCLUDED}', lambda f: mean(f[name]['clean_pct'] for name in scenarios), 99,
            100, 2, at_least=True),
        Bar(f'scenarios of {len(scenarios)} not slower than ORCA', lambda f: not_slower(f, orca),
            min(12, len(scenarios)), len(scenarios), 0, at_least=True),
        Bar('time / ORCA, geometric mean', lambda f: time_against(f, orca), 1.0, 0.9, 3),
        Bar('longest path', lambda f: greatest(f, 'path_ratio'), 1.12, None, 3),
        Bar("path minus ORCA's, greatest", lambda f: most_above(f, orca, 'path_ratio'), None, 0.02, 3),
        Bar(f'turning rad/m, greatest without {EXCLUDED}', lambda f: greatest(f, 'turn_rad_per_m', scenarios), 1.0,
            None),
        Bar('turning rad/m, greatest', lambda f: greatest(f, 'turn_rad_per_m'), 1.0, None),
        Bar("turning / ORCA's, greatest", lambda f: max(turn_against(f, orca).values()), None, 2),
        Bar('fastest tick / maximum speed', lambda f: greatest(f, 'max_speed_ratio'), 1.0, 1.0),
    ]
    cells = [bar.row(seeds) for bar in bars]
    time = Bar('training, processor time [s]', lambda value: value, 60, 10, 1)
    return cells + [time.row(seconds)]


def mean(values):
    numbers = list(values)
    return sum(numbers) / len(numbers)


def most_above(metrics, orca, key):
    return max(metrics[name][key] - orca[name][key] for name in judged(orca))


def turn_against(metrics, orca):
    """Returns turning / ORCA's turning, by scenario."""
    return {name: metrics[name]['turn_rad_per_m'] / orca[name]['turn_rad_per_m'] for name in judged(orca)
            if orca[name]['turn_rad_per_m'] > 0}
