"""Reads the file of a sweep."""
import difflib
import itertools
import pathlib
import typing

from crowd_drawing.errors import InputError, read_documents
from crowd_drawing.files import find_scenario

KEYS = {'': ('config', 'q_table', 'parameters', 'scenario_parameters', 'seeds', 'train', 'evaluate'),
        'train': ('episodes',), 'evaluate': ('scenarios', 'episodes', 'seed', 'trajectories')}


class Sweep(typing.NamedTuple):
    """A grid of parameters. Without a training configuration, a Q-table is evaluated."""
    file: pathlib.Path
    config: pathlib.Path  # or None
    q_table: pathlib.Path  # or None
    parameters: dict  # lists of values by the paths of keys in the training configuration
    scenario_parameters: dict  # the same, in each document of the evaluated scenarios
    seeds: list
    train_episodes: int  # None: those of the configuration
    scenarios: list  # files
    episodes: int
    evaluate_seed: int  # None: the seed of the run
    trajectories: bool  # of the first seed's first episode, for the report

    def combinations(self):
        """Returns all combinations as pairs of changes: of the configuration, and of the scenarios."""
        grids = ([dict(zip(grid, chosen)) for chosen in itertools.product(*grid.values())]
                 for grid in (self.parameters, self.scenario_parameters))
        return list(itertools.product(*grids))


def read_sweep(file):
    """Reads a Sweep; paths are relative to the file. Raises InputError, OSError."""
    reader = Reader(file)
    given = reader.map((read_documents(file) or [None])[0], '')
    train, evaluate = (reader.map(given.get(key) or {}, key) for key in ('train', 'evaluate'))
    if ('config' in given) == ('q_table' in given):
        raise InputError(f'{file}: expected either config or q_table')
    if 'q_table' in given and ('parameters' in given or train):
        raise InputError(f'{file}: with q_table nothing is trained; expected scenario_parameters in place of '
                         'parameters, and no train')
    scenarios = evaluate.get('scenarios')
    reader.need(isinstance(scenarios, list) and scenarios, 'evaluate.scenarios', 'a list of scenarios', scenarios)
    trajectories = evaluate.get('trajectories', True)
    reader.need(isinstance(trajectories, bool), 'evaluate.trajectories', 'true or false', trajectories)
    return Sweep(pathlib.Path(file), reader.path(given, 'config'), reader.path(given, 'q_table'),
                 reader.grid(given, 'parameters'), reader.grid(given, 'scenario_parameters'),
                 reader.seeds(given.get('seeds', 1)), reader.count(train, 'train.episodes', None, 1),
                 [reader.scenario(name) for name in scenarios], reader.count(evaluate, 'evaluate.episodes', 20, 1),
                 reader.count(evaluate, 'evaluate.seed', None, 0), trajectories)


class Reader:
    """Checks the values of a file."""

    def __init__(self, file):
        self.file = file

    def need(self, condition, where, expected, got):
        if not condition:
            raise InputError(f"{self.file}: {where + ': ' if where else ''}expected {expected}, got {got!r}")

    def map(self, value, where):
        """Returns a map, all of whose keys are known."""
        self.need(isinstance(value, dict), where, 'a map', value)
        for key in (key for key in value if key not in KEYS[where]):
            near = difflib.get_close_matches(str(key), KEYS[where], 1)
            hint = f", did you mean '{near[0]}'?" if near else '.'
            raise InputError(f"{self.file}: {where + ': ' if where else ''}unknown key '{key}'{hint} Known are "
                             f"{', '.join(KEYS[where])}")
        return value

    def grid(self, given, key):
        """Returns lists of values by paths; a single value counts as a list of one."""
        grid = given.get(key) or {}
        self.need(isinstance(grid, dict), key, 'a map of lists', grid)
        lists = {str(path): values if isinstance(values, list) else [values] for path, values in grid.items()}
        for path, values in lists.items():
            self.need(values, f'{key}.{path}', 'at least one value', values)
            self.need(all(value not in values[:i] for i, value in enumerate(values)), f'{key}.{path}',
                      'different values', values)
        return lists

    def seeds(self, value):
        """Returns the seeds: a list, or 1 to a number."""
        if is_whole(value, 1):
            return list(range(1, value + 1))
        fits = isinstance(value, list) and value and all(is_whole(seed, 0) for seed in value)
        self.need(fits and len(set(value)) == len(value), 'seeds', 'a number of seeds, or a list of different ones',
                  value)
        return value

    def count(self, given, path, default, least):
        value = given.get(path.split('.')[1], default)
        self.need(value is default or is_whole(value, least), path, f'a whole number from {least}', value)
        return value

    def path(self, given, key):
        """Returns a file relative to that of the sweep, which must exist."""
        if key not in given:
            return None
        self.need(isinstance(given[key], str), key, 'a file', given[key])
        path = (pathlib.Path(self.file).parent / given[key]).resolve()
        if not path.is_file():
            raise InputError(f'{self.file}: {key}: there is no file {path}')
        return path

    def scenario(self, name):
        """Returns the file of a scenario: relative to that of the sweep, or of this name in the package."""
        self.need(isinstance(name, str), 'evaluate.scenarios', 'names or files of scenarios', name)
        near = pathlib.Path(self.file).parent / name
        found = near if near.is_file() else pathlib.Path(find_scenario(name))
        if not found.is_file():
            raise InputError(f'{self.file}: evaluate.scenarios: there is no file {near.resolve()}')
        return found.resolve()


def is_whole(value, least):
    return isinstance(value, int) and not isinstance(value, bool) and value >= least
