"""Scenarios and Q-tables as users give them."""
import json
import os

from social_crowd._core import InputError, QTable, Scenario


def as_scenario(given):
    """Returns a Scenario.

    given: a Scenario; the name of a scenario of the package; a file; the text of a scenario file (with line breaks); a
    dict with the keys of a scenario file, or a list of such dicts, one for each document
    """
    if isinstance(given, Scenario):
        return given
    if isinstance(given, dict):
        return _parse([given])
    if isinstance(given, (list, tuple)) and given and all(isinstance(document, dict) for document in given):
        return _parse(given)
    if isinstance(given, str) and '\n' in given:
        return Scenario.parse(given, 'text')
    if isinstance(given, (str, os.PathLike)):
        return Scenario.load(os.fspath(given))
    raise InputError(f'scenario: expected a name, a file, text, a dict or a Scenario, got {type(given).__name__}')


def as_table(given):
    """Returns a QTable. given: a QTable, the name of a Q-table of the package, or a file"""
    if isinstance(given, QTable):
        return given
    if isinstance(given, (str, os.PathLike)):
        return QTable.load(os.fspath(given))
    raise InputError(f'table: expected a name, a file or a QTable, got {type(given).__name__}')


def dump(document):
    """Returns a dict as YAML, of which JSON is a part; NumPy's numbers and arrays may be in it."""
    return json.dumps(document, default=lambda value: value.tolist(), ensure_ascii=False, allow_nan=False)


def _parse(documents):
    try:
        text = '\n---\n'.join(map(dump, documents))
    except (TypeError, ValueError, AttributeError) as error:
        raise InputError(f'scenario: a dict cannot be written as YAML: {error}') from None
    return Scenario.parse(text, 'dict')
