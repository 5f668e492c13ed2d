"""Folders and numbers that all experiments share; variations of shipped training configurations and scenarios."""
import copy
import dataclasses
import math
import pathlib
import typing

import yaml
from crowd_drawing.errors import read_documents
from crowd_drawing.files import shipped_scenarios

from .tools import REPOSITORY

DUMPER = getattr(yaml, 'CSafeDumper', yaml.SafeDumper)  # the faster implementation, if available
EVERY = '*'  # in a path of keys: each entry of a list


@dataclasses.dataclass(frozen=True)
class Setting:
    """Folders and numbers that all experiments share."""
    tools: pathlib.Path  # folder of train and evaluate
    config: pathlib.Path  # the package's config/
    results: pathlib.Path
    quick: bool = False  # minimal numbers, to test the programs
    experiments: pathlib.Path = REPOSITORY / 'research' / 'experiments'  # training configurations
    benchmark: typing.Optional[pathlib.Path] = None  # folder of the steering benchmark

    def count(self, full, quick):
        return quick if self.quick else full

    def seeds(self, full, quick=2):
        return range(1, self.count(full, quick) + 1)

    def scenario(self, name):
        return self.config / 'scenarios' / f'{name}.yaml'

    def learning(self, model):
        return self.config / 'learning' / f'{model}.yaml'

    def table(self, model):
        return self.config / 'q_tables' / f'{model}.txt'

    def run_folder(self, experiment, run):
        return self.results / 'runs' / experiment / run


def vary_config(setting, base, changes, name, scenarios=None):
    """Writes a variation of the training configuration `base`, a name in config/experiments or a file. Returns the new
    file.

    Changes are new values by the paths of their keys, such as {'learning.epsilon': 0.05}; None removes a key.
    Scenarios, by default those of the base, are files relative to it, else the package's of these names."""
    file = base if isinstance(base, pathlib.Path) else setting.experiments / f'{base}.yaml'
    config = changed(read_documents(file)[0], changes)
    training = config['training']
    shipped = shipped_scenarios()
    near = [(name, (file.parent / name).resolve()) for name in scenarios or training['scenarios']]
    training['scenarios'] = [str(path if path.exists() else shipped.get(name, path)) for name, path in near]
    return write_if_new(setting.results / 'configs' / f'{name}.yaml', file, [config])


def vary_scenario(setting, base, changes, name):
    """Writes a variation of the scenario file `base`, a name in config/scenarios or a file, with changes in each of its
    documents. Returns the new file. Changes as above, such as {'agents.*.heading': 'goal'}. In results, the scenario is
    identified by its key `name`, which is unchanged unless `changes` contains it."""
    file = base if isinstance(base, pathlib.Path) else setting.scenario(base)
    documents = [changed(document, changes) for document in read_documents(file)]
    return write_if_new(setting.results / 'configs' / 'scenarios' / f'{name}.yaml', file, documents)


def heading_of(agent):
    """Returns the heading of an agent in a scene that `evaluate --scenes` has written [degrees]."""
    heading = agent['heading']
    return math.degrees(heading['radians']) if isinstance(heading, dict) else heading


def changed(document, changes):
    """Returns a copy of a document with changed values."""
    document = copy.deepcopy(document)
    for path, value in changes.items():
        change(document, path.split('.'), value)
    return document


def change(node, keys, value):
    """Sets a key below a map or a list, or removes it if the value is None. Missing maps on the path are created."""
    key, *rest = keys
    if isinstance(node, list):
        for entry in node if key == EVERY else [node[int(key)]]:
            change(entry, rest, value)
    elif rest:
        if EVERY in rest[:1] and not node.get(key):
            raise ValueError(f"there are no '{key}' to change")
        change(node.setdefault(key, {}), rest, value)
    elif value is None:
        node.pop(key, None)
    else:
        node[key] = copy.deepcopy(value)


def write_if_new(file, base, documents):
    content = yaml.dump_all(documents, None, DUMPER, sort_keys=False, default_flow_style=None)
    text = f'# Made from {base.name}.\n{content}'
    if not file.is_file() or file.read_text(encoding='utf-8') != text:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding='utf-8')
    return file
