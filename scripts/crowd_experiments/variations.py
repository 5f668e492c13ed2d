"""Variations of shipped training configurations and scenarios, written beside the results."""
import copy
import pathlib

import yaml

LOADER = getattr(yaml, 'CSafeLoader', yaml.SafeLoader)  # the fast ones where they are there
DUMPER = getattr(yaml, 'CSafeDumper', yaml.SafeDumper)
EVERY = '*'  # in a path of keys: each entry of a list


def vary_config(setting, base, changes, name, scenarios=None):
    """The training configuration `base`, a name in config/experiments or a file, with other values; returns the file
    of that name.

    Changes are new values by the paths of their keys, such as {'learning.epsilon': 0.05}; None removes a key. It
    trains on the scenarios given, or on those of its base."""
    file = base if isinstance(base, pathlib.Path) else setting.config_file(base)
    config = changed(read_documents(file)[0], changes)
    training = config['training']
    training['scenarios'] = [str((file.parent / scenario).resolve()) for scenario in scenarios or training['scenarios']]
    return write_if_new(setting.results / 'configs' / f'{name}.yaml', file, [config])


def vary_scenario(setting, base, changes, name):
    """The scenario file `base`, a name in config/scenarios or a file, with other values in each of its documents;
    returns the file of that name. Changes as above, such as {'agents.*.heading': 'goal'}. What results call the
    scenario is its key `name`, which stays as it is unless it is changed, too."""
    file = base if isinstance(base, pathlib.Path) else setting.scenario(base)
    documents = [changed(document, changes) for document in read_documents(file)]
    return write_if_new(setting.results / 'configs' / 'scenarios' / f'{name}.yaml', file, documents)


def read_documents(file):
    """The YAML documents of a file."""
    with open(file, encoding='utf-8') as stream:
        return [document for document in yaml.load_all(stream, LOADER) if document is not None]


def changed(document, changes):
    """A copy of a document in which the keys at those paths have other values."""
    document = copy.deepcopy(document)
    for path, value in changes.items():
        change(document, path.split('.'), value)
    return document


def change(node, keys, value):
    """Sets a key below a map or a list, or removes it if the value is None. Maps on the way to it are made."""
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
    """Writes the documents, which come from a base; leaves the file alone if it holds just them."""
    content = yaml.dump_all(documents, None, DUMPER, sort_keys=False, default_flow_style=None)
    text = f'# Made from {base.name}.\n{content}'
    if not file.is_file() or file.read_text(encoding='utf-8') != text:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding='utf-8')
    return file
