"""Seeds of the episodes of an environment."""
import numpy
from social_crowd.checks import whole_number


class EpisodeSeeds:
    """Draws the seed of each episode of one environment.

    With a seed, the episode is drawn from that seed, and later episodes from it, too: the same calls give the same
    episodes. Without one, it is drawn anew.
    """

    def __init__(self, scenarios=1):
        self.random = numpy.random.default_rng()
        self._scenarios = scenarios

    def next(self, seed=None):
        """Returns index of the scenario, and seed, of the next episode."""
        if seed is not None:
            drawn = whole_number('seed', seed)
            self.random = numpy.random.default_rng(drawn)
        else:
            drawn = int(self.random.integers(2 ** 31))
        return int(self.random.integers(self._scenarios)) if self._scenarios > 1 else 0, drawn
