"""What the runs have written: a measure is a value for each seed. Names and texts of figures and tables."""
import dataclasses
import functools

import numpy
import pandas
from crowd_drawing.files import place_of, read_scene
from crowd_experiments.records import Spread, median, read_csv, read_table_header, read_tracks, read_visits
from crowd_experiments.runs import Run
from crowd_experiments.variations import Setting
from crowd_studies.program import Report, read_texts

from .declared import BETTER, GROUPS, NEEDS, READINGS, THESIS, VARIATIONS, combinations, commands_of, parameters_of

RATES = {'success': 'arrived', 'collision': 'collided', 'contact': 'touched'}  # in the order of all texts
DECISIONS = ['instance', 'tick', 'agent', 'x', 'y', 'heading', 'row', 'action', 'occupied']  # columns of a file
TEXTS = read_texts(__file__)
REWARD_COLOURS = {'distance_gained': '#0072b2', 'cosine_cubed': '#d55e00'}
REWARD_NAMES = {'distance_gained': 'distance gained', 'cosine_cubed': 'cos³'}
PARAMETER_NAMES = {THESIS: "thesis's parameters", BETTER: 'better parameters',
                   **{name: f"thesis's parameters, {reading['label']}" for name, reading in READINGS.items()}}
RATE_HEADER = [f'{rate} %' for rate in RATES]


def plan(experiment):
    """Returns the function that plans the runs of an experiment."""
    def runs(setting):
        return [run for group in NEEDS[experiment] for run in runs_of(setting, group)]
    return runs


@functools.lru_cache(maxsize=None)  # several experiments need a group
def runs_of(setting, group):
    return list(planned_runs(setting, group))


def planned_runs(setting, group):
    declared = GROUPS[group]
    for keys in combinations(setting, {'seed': setting.seeds(declared['seeds']), **declared['each']}):
        is_other = 'parameters' in keys and parameters_of(setting, keys) != keys['parameters']
        if is_other or VARIATIONS.get(keys.get('variation'), {}).get('sets') not in (None, keys.get('states')):
            continue  # the same as another run, or of the other state set
        yield Run(Runs.of(setting, group, **keys).folder(keys['seed']), [
            command for line in declared['commands'] for command in commands_of(setting, line, keys)], declared['cost'])


@dataclasses.dataclass(frozen=True)
class Runs:
    """The runs of a group that differ only in their seeds."""
    setting: Setting
    group: str
    keys: tuple  # of pairs

    @classmethod
    def of(cls, setting, group, **keys):
        """Returns the runs with these keys; the seed is ignored. By default, or with `thesis`, the parameters are those
        of the setting's reading."""
        if 'parameters' in GROUPS[group]['each']:
            keys['parameters'] = parameters_of(setting, keys)
        setting = Setting(*(getattr(setting, field.name) for field in dataclasses.fields(Setting)))  # one cache for all
        return cls(setting, group, tuple(sorted((key, value) for key, value in keys.items() if key != 'seed')))

    def seeds(self):
        return self.setting.seeds(GROUPS[self.group]['seeds'])

    def folder(self, seed):
        declared = GROUPS[self.group]
        return self.setting.run_folder(declared['in'], declared['folder'].format(seed=seed, **dict(self.keys)))

    @functools.lru_cache(maxsize=None)
    def record(self, file, scenario=None):
        """Returns a record of all seeds as one table with the column seed; of one scenario, if it is given."""
        if scenario is not None:
            rows = self.record(file)
            return rows[rows['scenario'] == scenario]
        rows = {seed: pandas.DataFrame(read_csv(self.folder(seed) / file)) for seed in self.seeds()}
        return pandas.concat(rows, names=['seed', 'row']).reset_index('seed')

    def rates(self, file, scenario=None):
        return rates_of(self.record(file, scenario))

    def arrivals(self, file, column, scenario=None):
        """Returns the median of a column over the agents that arrived, for each seed; nan without arrivals."""
        return per_seed(self.record(file, scenario), lambda rows: median(rows[column][rows['arrived'] > 0]))

    def whole(self, file, scenario, *incidents):
        """Returns the share of the episodes [%] in which all agents arrive without these incidents, for each seed."""
        sums = episodes_of(self.record(file, scenario))
        fine = (sums['arrived'] == sums['agents']) & (sums[list(incidents)] == 0).all(axis=1)
        return 100.0 * fine.groupby('seed').mean()

    def headers(self, table, key):
        return [float(read_table_header(self.folder(seed) / table)[key]) for seed in self.seeds()]

    @functools.lru_cache(maxsize=None)
    def tracks(self, seed, file):
        return read_tracks(self.folder(seed) / file)

    @functools.lru_cache(maxsize=None)
    def decisions(self, seed, scenario, folder='states'):
        return read_decisions(self.folder(seed) / folder / f'{scenario}.csv')

    @functools.lru_cache(maxsize=None)
    def visits(self, seed):
        """Returns the number of visits of each row of the Q-table in training, as an array."""
        return visits_in(self.folder(seed) / 'q_table.txt')


def rates_of(rows):
    """Returns success, collision and contact [%] as the columns of a table with a row for each seed: shares of the
    agents. A contact is an overlap of bodies; a collision is a rim within the collision radius (thesis, 4.1)."""
    return 100.0 * rows.groupby('seed')[list(RATES.values())].mean().set_axis(list(RATES), axis=1)


def per_seed(rows, measure):
    return [measure(of_seed) for _, of_seed in rows.groupby('seed')]


def episodes_of(rows):
    """Returns sums of agents for each seed and episode, and the tick of the last arrival or the end of the time."""
    episodes = rows.groupby(['seed', 'episode'])
    return episodes[list(RATES.values())].sum().assign(agents=episodes.size(), ticks=episodes['ticks'].max())


def read_decisions(file):
    """Returns a table of decisions; the column `occupied` has texts, `sectors` the number of occupied sectors."""
    with open(file, encoding='utf-8') as stream:
        if next(stream, '').rstrip('\n').split(',') != DECISIONS:
            raise ValueError(f"{file}:1: expected the header {','.join(DECISIONS)}")
        decisions = pandas.read_csv(stream, names=DECISIONS, keep_default_na=False, dtype={
            'x': float, 'y': float, 'heading': float, 'occupied': str})
    return decisions.assign(sectors=decisions['occupied'].str.count(':').floordiv(2))


def visits_in(file):
    """Returns the number of visits of each row of a Q-table, as an array."""
    found = pandas.Series(read_visits(file))
    return found.reindex(range(int(read_table_header(file)['rows'])), fill_value=0).to_numpy()


def obstacle_places(setting, scenario, ticks):
    """Returns the places of the first obstacle of a scenario at each tick from the start [m]."""
    scene = read_scene(setting.scenario(scenario), 0)
    return numpy.array([place_of(scene.obstacles[0], tick * scene.tick) for tick in range(ticks)])


def report_of(name, setting, seeds, **values):
    """Returns the empty chapter of an experiment with this number of seeds, and its first text."""
    report = Report(name, TEXTS, setting, seeds=len(setting.seeds(seeds)), spread=TEXTS['spread'], **values)
    report.say('intro')
    return report


def rate_texts(rates):
    """Returns the texts of success, collision and contact, given a table with a row for each seed."""
    return [Spread(rates[rate]).text(1) for rate in RATES]


def rates_sentence(rates):
    return 'success {} %, collision {} %, contact {} %'.format(*rate_texts(rates))


def means_sentence(rates, contact=0):
    """Returns the means as part of a sentence; `contact`: decimals of its contact."""
    means = rates.mean()
    return f'success {means.success:.0f} %, collision {means.collision:.0f} %, contact {means.contact:.{contact}f} %'
