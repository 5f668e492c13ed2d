"""The bars that the anticipating crowd is to clear, and whether it does."""
from .metrics_csv import WITHOUT_WAY, greatest, judged, least, not_slower, time_against

HEADER = ['asked for', 'bar', 'seed 1', 'worst seed', 'bar is met by', 'aim', 'aim is met by']


class Bar:
    """A number that is not to be above its bar and aim, or not below them; either may be None."""

    def __init__(self, label, measure, bar, aim, decimals=2, at_least=False):
        self.label, self.measure, self.bar, self.aim = label, measure, bar, aim
        self.decimals, self.at_least = decimals, at_least

    def row(self, seeds):
        """Cells: what each of the seeds' figures gives, against bar and aim."""
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
        """By all, by none, or by how many seeds."""
        if limit is None:
            return ''
        slack = 1e-9  # of sums of floating-point numbers, far below what is printed
        count = sum(value >= limit - slack if self.at_least else value <= limit + slack for value in values)
        return {len(values): 'all seeds', 0: 'none'}.get(count, f'{count} of {len(values)}')


def rows(seeds, orca, seconds):
    """A row for each bar.
    @param seeds figures of each training seed, seed 1 first
    @param orca what time, path and turning are measured against
    @param seconds processor time that each training took [s]"""
    scenarios = judged(orca)
    bars = [
        Bar('contact %, worst scenario', lambda f: greatest(f, 'contact_pct'), 0, 0),
        Bar(f'clean %, worst scenario but {WITHOUT_WAY}', lambda f: least(f, 'clean_pct', scenarios), 100, 100, 0,
            at_least=True),
        Bar('clean %, worst scenario', lambda f: least(f, 'clean_pct'), None, 100, 0, at_least=True),
        Bar(f'clean %, mean but {WITHOUT_WAY}', lambda f: mean(f[name]['clean_pct'] for name in scenarios), 99, 100, 2,
            at_least=True),
        Bar(f'scenarios of {len(scenarios)} not slower than ORCA', lambda f: not_slower(f, orca),
            min(12, len(scenarios)), len(scenarios), 0, at_least=True),
        Bar('time / ORCA, geometric mean', lambda f: time_against(f, orca), 1.0, 0.9, 3),
        Bar('path, longest', lambda f: greatest(f, 'path_ratio'), 1.12, None, 3),
        Bar("path above ORCA's, most", lambda f: most_above(f, orca, 'path_ratio'), None, 0.02, 3),
        Bar(f'turning rad/m, most but {WITHOUT_WAY}', lambda f: greatest(f, 'turn_rad_per_m', scenarios), 1.0, None),
        Bar('turning rad/m, most', lambda f: greatest(f, 'turn_rad_per_m'), 1.0, None),
        Bar("turning / ORCA's, most", lambda f: max(turn_against(f, orca).values()), None, 2),
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
    """Turning against ORCA's, by scenario."""
    return {name: metrics[name]['turn_rad_per_m'] / orca[name]['turn_rad_per_m'] for name in judged(orca)
            if orca[name]['turn_rad_per_m'] > 0}
