"""The runs that runs.yaml declares, and what they have written: a measure is a value for each seed. Names and texts of
figures and tables."""
import dataclasses
import functools
import itertools
import pathlib
import re
from types import MappingProxyType

import numpy
import pandas
import yaml
from crowd_drawing.files import place_of, read_scene
from crowd_experiments.records import Spread, median, read_csv, read_table_header, read_tracks, read_visits
from crowd_experiments.runs import Run
from crowd_experiments.variations import EVERY, Setting, read_documents, vary_config, vary_scenario
from crowd_studies.program import Report, read_texts

DECLARED = yaml.safe_load(pathlib.Path(__file__).with_name('runs.yaml').read_text(encoding='utf-8'))
GROUPS, LISTS, NEEDS, READINGS = (DECLARED[key] for key in ('groups', 'lists', 'needs', 'readings'))
LEAD = next(iter(READINGS))  # the reading of the thesis that leads
THESIS, BETTER = 'thesis', 'better'  # parameters: `thesis` stands for those of the reading of a setting
EPSILON = 0.1  # of the thesis's parameters, where no reading changes it
DEMO_SEED = 1000  # is added to the seed of the training, so that the places differ from those of the training
RATES = {'success': 'arrived', 'collision': 'collided', 'contact': 'touched'}  # in the order of all texts
SETS, REWARDS = ('nearest', 'occupancy'), ('distance_gained', 'cosine_cubed')
PARAMETERS = {states: [*(name for name, reading in READINGS.items() if reading.get('sets', states) == states), BETTER]
              for states in SETS}  # all readings that differ with a state set, and better parameters
DRAWN = (THESIS, BETTER)  # parameters of figures
DECISIONS = ['instance', 'tick', 'agent', 'x', 'y', 'heading', 'row', 'action', 'occupied']  # columns of a file
TEXTS = read_texts(__file__)
REWARD_COLOURS = {'distance_gained': '#0072b2', 'cosine_cubed': '#d55e00'}
REWARD_NAMES = {'distance_gained': 'distance gained', 'cosine_cubed': 'cos³'}
PARAMETER_NAMES = {THESIS: "thesis's parameters", BETTER: 'better parameters',
                   **{name: f"thesis's parameters, {reading['label']}" for name, reading in READINGS.items()}}
RATE_HEADER = [f'{rate} %' for rate in RATES]


def value_text(value):
    """15, 45, 90, 180; 0.3 to 0.01, exponential"""
    if isinstance(value, dict):
        within = f" within {value['episodes']} episodes" if 'episodes' in value else ''
        return f"{value['from']} to {value['to']}, {value['shape']}{within}"
    if value is None:
        return 'equal'
    return ', '.join(map(str, value)) if isinstance(value, list) else str(value)


def variation_of(choice, value):
    label = f"{choice['name']}: {value_text(value)}"
    return re.sub(r'[^a-z0-9.]+', '_', label.lower()).strip('_'), {
        'label': label, 'choice': choice['name'], 'value': value_text(value), 'sets': choice.get('sets'),
        **{file: {choice[file]: value} for file in ('config', 'scenario') if file in choice}}


def choices_in(key):
    """Returns the variations of choices by their names, that without a change first."""
    return {'leading': {'label': 'reading that leads'},
            **dict(variation_of(choice, value) for choice in DECLARED[key] for value in choice['others'])}


CHOICES, CROWD_CHOICES = map(choices_in, ('choices', 'crowd_choices'))
VARIATIONS = {**DECLARED['variations'], **CHOICES, **CROWD_CHOICES}
NAMED_CHOICES = {'choices': CHOICES, 'crowd_choices': CROWD_CHOICES}
LISTED = {'all': [*READINGS, BETTER], 'readings': list(READINGS)}  # values of keys of runs, by their names


def choices_of(setting, choices=MappingProxyType(CHOICES)):
    """Returns the names of the variations of choices that are tried, that without a change first."""
    return list(choices)[:3] if setting.quick else list(choices)


def chosen(setting, choice):
    file = config_file(setting, f'reward_{REWARDS[0]}', {'reward': REWARDS[0]}) if 'config' in choice else \
        setting.scenario('single_obstacle')
    value = read_documents(file)[0]
    for key in (choice.get('config') or choice['scenario']).split('.'):
        value = value[0] if key == EVERY else value.get(key, choice.get('default', ''))
    return value_text(value)


def scenario_file(setting, name, variation=None):
    """Returns the file of a scenario, which is written if it is not shipped as it is."""
    made = DECLARED['scenarios'].get(name)
    keys = VARIATIONS.get(variation, {}).get('scenario')
    base = vary_scenario(setting, made['of'], made['keys'], name) if made else setting.scenario(name)
    if keys and all(EVERY not in key or key.split('.')[0] in read_documents(base)[0] for key in keys):
        return vary_scenario(setting, base, keys, f'{name}_{variation}')
    return base


@dataclasses.dataclass(frozen=True)
class Reading(Setting):
    """A setting in which `thesis` stands for another reading of the thesis's parameters."""
    reading: str = LEAD

    @classmethod
    def of(cls, setting, reading):
        return cls(**{**vars(setting), 'reading': reading})


def parameters_of(setting, keys):
    """Returns the parameters of runs: a reading, or better parameters. With state set 1, the sectors of set 2 do not
    differ."""
    name = keys.get('parameters', THESIS)
    if name == THESIS:
        name = getattr(setting, 'reading', LEAD)
    states = keys.get('states', SETS[0] if 'reward' in keys else SETS[1])
    return name if name in PARAMETERS[states] else READINGS[name]['otherwise']


def config_file(setting, name, keys, episodes=None):
    """Returns the training configuration of a run, which is written if it is not NAME_thesis or NAME_better. An epsilon
    of its own, other than that of the first training, is not changed. A schedule without a length has that of the
    training, by default the number of episodes in the file."""
    parameters, variation = parameters_of(setting, keys), VARIATIONS.get(keys.get('variation'), {})
    base = setting.experiments / f'{name}_{BETTER if parameters == BETTER else THESIS}.yaml'
    config = read_documents(base)[0]
    changes = {**READINGS.get(parameters, {}).get('config', {}), **variation.get('config', {})}
    if config['learning']['epsilon'] != EPSILON:
        changes.pop('learning.epsilon', None)
    elif isinstance(changes.get('learning.epsilon'), dict):
        changes['learning.epsilon'] = {'episodes': episodes or config['training']['episodes'],
                                       **changes['learning.epsilon']}
    scenarios = [scenario_file(setting, pathlib.Path(file).stem, keys.get('variation'))
                 for file in config['training']['scenarios']] if 'scenario' in variation else None
    if not changes and not scenarios:
        return base
    words = [name, parameters, keys.get('variation'), episodes and str(episodes)]
    return vary_config(setting, base, changes, '_'.join(filter(None, words)), scenarios)


def words_of(setting, word, keys, episodes=None):
    if word.startswith('@'):
        return [config_file(setting, word[1:], keys, episodes)]
    if word.startswith('~'):
        return [scenario_file(setting, name, keys.get('variation')) for name in LISTS.get(word[1:], [word[1:]])]
    full, bar, quick = word.partition('|')
    return [setting.count(full, quick) if bar else word]


def commands_of(setting, declared, keys):
    """Yields the commands of a declared one, which may be for certain runs only, or for several values."""
    if isinstance(declared, str):
        text = declared.format(**keys).split()
        episodes = int(words_of(setting, text[text.index('--episodes') + 1], keys)[0]) if '--episodes' in text else None
        words = [part for word in text for part in words_of(setting, word, keys, episodes)]
        if words[0] == 'walk':
            words[:2] = ['evaluate', '--q-table', words[1], '--threads', 1, '--seed', DEMO_SEED + keys['seed']]
        yield [setting.tools / words[0], *words[1:]]
    elif all(keys[key] == value for key, value in declared.get('when', {}).items()):
        for more in combinations(setting, declared.get('each', {})):
            yield from commands_of(setting, declared['run'], {**keys, **more})


def values_of(setting, listed):
    """Returns the values of a key of runs. '0 10 100|0 5' stands for 0, 10 and 100, with --quick for 0 and 5; a list is
    taken as it is."""
    if not isinstance(listed, str):
        return listed
    if listed in NAMED_CHOICES:
        return choices_of(setting, NAMED_CHOICES[listed])
    return LISTED.get(listed) or list(map(int, setting.count(*listed.split('|')).split()))


def combinations(setting, each):
    """Yields all combinations of values by their keys."""
    values = [values_of(setting, listed) for listed in each.values()]
    return (dict(zip(each, chosen_ones)) for chosen_ones in itertools.product(*values))


def plan(experiment):
    """Returns the function that plans the runs of an experiment."""
    def runs(setting):
        return [run for group in NEEDS[experiment] for run in runs_of(setting, group)]
    return runs


def runs_of(setting, group):
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
