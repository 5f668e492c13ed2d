"""Spaces of actions and observations: Gymnasium's if it is installed, else small ones with the same members."""
import numpy

try:
    from gymnasium.spaces import Box, Dict
except ImportError:

    class Space:
        """A set of values with a random generator."""

        def __init__(self, shape, dtype, seed=None):
            self._shape = shape
            self.dtype = None if dtype is None else numpy.dtype(dtype)
            self._np_random = None
            if seed is not None:
                self.seed(seed)

        @property
        def shape(self):
            """Its shape; None for a Dict."""
            return self._shape

        @property
        def np_random(self):
            """Generator of sample()."""
            if self._np_random is None:
                self.seed()
            return self._np_random

        def seed(self, seed=None):
            """Seeds the generator of sample(). Returns the seed."""
            self._np_random = numpy.random.default_rng(seed)
            return seed

        def __contains__(self, x):
            return self.contains(x)

    class Box(Space):
        """Arrays of a shape and a dtype between two bounds, which belong to it."""

        def __init__(self, low, high, shape=None, dtype=numpy.float32, seed=None):
            shape = tuple(shape) if shape is not None else numpy.broadcast(low, high).shape
            super().__init__(shape, dtype, seed)
            self.low = numpy.full(shape, low, dtype) if numpy.isscalar(low) else numpy.asarray(low, dtype)
            self.high = numpy.full(shape, high, dtype) if numpy.isscalar(high) else numpy.asarray(high, dtype)
            self.bounded_below = self.low > -numpy.inf
            self.bounded_above = self.high < numpy.inf

        @property
        def is_np_flattenable(self):
            """Whether a value is one array."""
            return True

        def is_bounded(self, manner='both'):
            """Whether it has bounds: both, below or above."""
            bounds = {'below': self.bounded_below.all(), 'above': self.bounded_above.all()}
            return bool(all(bounds.values()) if manner == 'both' else bounds[manner])

        def sample(self, mask=None):
            """Returns a random value: uniform between bounds, normal without, exponential beside one."""
            if mask is not None:
                raise ValueError(f'a Box takes no mask, got {mask}')
            random = self.np_random
            value = random.normal(size=self.shape)
            both = self.bounded_below & self.bounded_above
            below, above = self.bounded_below & ~both, self.bounded_above & ~both
            top = self.high.astype(float) + (1 if self.dtype.kind in 'iu' else 0)
            value[both] = random.uniform(self.low[both], top[both])
            value[below] = self.low[below] + random.exponential(size=below.sum())
            value[above] = self.high[above] - random.exponential(size=above.sum())
            return (numpy.floor(value) if self.dtype.kind in 'iu' else value).astype(self.dtype)

        def contains(self, x):
            """Whether an array, or what can be made one without loss, is in it."""
            x = numpy.asarray(x)
            return bool(numpy.can_cast(x.dtype, self.dtype) and x.shape == self.shape and
                        numpy.all(x >= self.low) and numpy.all(x <= self.high))

        def __eq__(self, other):
            return (isinstance(other, Box) and self.shape == other.shape and self.dtype == other.dtype and
                    numpy.array_equal(self.low, other.low) and numpy.array_equal(self.high, other.high))

        def __repr__(self):
            return f'Box({self.low.min()}, {self.high.max()}, {self.shape}, {self.dtype})'

    class Dict(Space):
        """Dicts with a value of a space for each key."""

        def __init__(self, spaces, seed=None):
            self.spaces = dict(spaces)
            super().__init__(None, None, seed)

        @property
        def is_np_flattenable(self):
            """Whether all values are arrays."""
            return True

        def seed(self, seed=None):
            """Seeds the generators of all spaces. Returns the seeds by key."""
            super().seed(seed)
            drawn = self.np_random.integers(2 ** 31, size=len(self.spaces))
            return {key: space.seed(int(own)) for (key, space), own in zip(self.spaces.items(), drawn)}

        def sample(self, mask=None):
            """Returns a dict of random values."""
            return {key: space.sample(None if mask is None else mask[key]) for key, space in self.spaces.items()}

        def contains(self, x):
            """Whether a dict has all keys and no other, with values of their spaces."""
            return (isinstance(x, dict) and x.keys() == self.spaces.keys() and
                    all(x[key] in space for key, space in self.spaces.items()))

        def keys(self):
            """Its keys."""
            return self.spaces.keys()

        def values(self):
            """Its spaces."""
            return self.spaces.values()

        def items(self):
            """Its keys and spaces."""
            return self.spaces.items()

        def __getitem__(self, key):
            return self.spaces[key]

        def __iter__(self):
            return iter(self.spaces)

        def __len__(self):
            return len(self.spaces)

        def __eq__(self, other):
            return isinstance(other, Dict) and self.spaces == other.spaces

        def __repr__(self):
            return 'Dict(' + ', '.join(f'{key!r}: {space}' for key, space in self.spaces.items()) + ')'


def batched(space, count):
    """Returns the space of `count` values of a space side by side."""
    if isinstance(space, Dict):
        return Dict({key: batched(own, count) for key, own in space.items()})
    return Box(numpy.repeat(space.low[None], count, axis=0), numpy.repeat(space.high[None], count, axis=0),
               dtype=space.dtype)
