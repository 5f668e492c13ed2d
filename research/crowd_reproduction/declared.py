"""What runs.yaml declares: readings of the thesis, choices that it leaves open, and the commands of runs."""
import dataclasses
import functools
import itertools
import pathlib
import re
from types import MappingProxyType

from crowd_experiments.variations import EVERY, Setting, read_documents, vary_config, vary_scenario

DECLARED = read_documents(pathlib.Path(__file__).with_name('runs.yaml'))[0]
GROUPS, LISTS, NEEDS, READINGS = (DECLARED[key] for key in ('groups', 'lists', 'needs', 'readings'))
LEAD = next(iter(READINGS))  # the reading of the thesis that leads
THESIS, BETTER = 'thesis', 'better'  # parameters: `thesis` stands for those of the reading of a setting
EPSILON = 0.1  # of the thesis's parameters, where no reading changes it
DEMO_SEED = 1000  # is added to the seed of the training, so that the places differ from those of the training
SETS, REWARDS = ('nearest', 'occupancy'), ('distance_gained', 'cosine_cubed')
PARAMETERS = {states: [*(name for name, reading in READINGS.items() if reading.get('sets', states) == states), BETTER]
              for states in SETS}  # all readings that differ with a state set, and better parameters
DRAWN = (THESIS, BETTER)  # parameters of figures


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


@functools.lru_cache(maxsize=None)  # all seeds need a file
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
