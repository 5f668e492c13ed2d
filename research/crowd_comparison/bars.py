"""The requirements (bars) and aims for the anticipation crowd, and whether they are met."""
import typing

from .models import EXCLUDED, judged, not_slower, time_against

HEADER = ['metric', 'bar', 'seed 1', 'worst seed', 'bar met by', 'aim', 'aim met by']
SLACK = 1e-9  # rounding error of floating-point sums, far below the printed precision


class Bar(typing.NamedTuple):
    """An upper or lower limit of a metric, and a stricter limit as an aim; either may be None."""
    label: str
    measure: typing.Callable
    bar: float
    aim: float
    decimals: int = 2
    at_least: bool = False

    def row(self, seeds):
        """Returns the cells of a row: the values of the seeds' metrics, compared with bar and aim."""
        values = [self.measure(metrics) for metrics in seeds]
        worst = min(values) if self.at_least else max(values)
        first, worst = (f'{value:.{self.decimals}f}' for value in (values[0], worst))
        return [self.label, self.limit(self.bar), first, worst, self.met(values, self.bar), self.limit(self.aim),
                self.met(values, self.aim)]

    def limit(self, limit):
        return '' if limit is None else f"{'≥' if self.at_least else '≤'} {limit:.{self.decimals}f}"

    def met(self, values, limit):
        """Returns a text with the number of seeds that meet a limit."""
        if limit is None:
            return ''
        count = sum(value >= limit - SLACK if self.at_least else value <= limit + SLACK for value in values)
        return {len(values): 'all seeds', 0: 'none'}.get(count, f'{count} of {len(values)}')


def rows(seeds, orca, seconds):
    """Returns a row for each bar.
    @param seeds metrics of each training seed, seed 1 first
    @param orca metrics that time, path and turning are compared with
    @param seconds processor time of each training [s]"""
    count, turning = len(judged(orca)), judged(orca).turn_rad_per_m
    bars = [
        Bar('contact %, worst scenario', lambda f: f.contact_pct.max(), 0, 0),
        Bar(f'clean %, worst scenario without {EXCLUDED}', lambda f: judged(f).clean_pct.min(), 100, 100, 0,
            at_least=True),
        Bar('clean %, worst scenario', lambda f: f.clean_pct.min(), None, 100, 0, at_least=True),
        Bar(f'clean %, mean without {EXCLUDED}', lambda f: judged(f).clean_pct.mean(), 99, 100, 2, at_least=True),
        Bar(f'scenarios of {count} not slower than ORCA', lambda f: not_slower(f, orca), min(12, count), count, 0,
            at_least=True),
        Bar('time / ORCA, geometric mean', lambda f: time_against(f, orca), 1.0, 0.9, 3),
        Bar('longest path', lambda f: f.path_ratio.max(), 1.12, None, 3),
        Bar("path minus ORCA's, greatest", lambda f: judged(f.path_ratio - orca.path_ratio).max(), None, 0.02, 3),
        Bar(f'turning rad/m, greatest without {EXCLUDED}', lambda f: judged(f).turn_rad_per_m.max(), 1.0, None),
        Bar('turning rad/m, greatest', lambda f: f.turn_rad_per_m.max(), 1.0, None),
        Bar("turning / ORCA's, greatest", lambda f: (f.turn_rad_per_m / turning[turning > 0]).max(), None, 2),
        Bar('fastest tick / maximum speed', lambda f: f.max_speed_ratio.max(), 1.0, 1.0),
    ]
    time = Bar('training, processor time [s]', lambda value: value, 60, 10, 1)
    return [*(bar.row(seeds) for bar in bars), time.row(seconds)]
