"""The files of a report, recognised by their headers."""
import dataclasses
import pathlib

from crowd_drawing.errors import InputError
from crowd_drawing.files import HEADER
from crowd_experiments.arguments import labelled
from crowd_experiments.records import read_csv

METRICS, LOG, RECORD, TRAJECTORIES = 'metrics', 'log', 'record', 'trajectories'
# First columns, by kind; those of a log begin with those of a record.
HEADERS = {METRICS: ('scenario,instances,success_pct', '`evaluate --csv`'),
           LOG: ('episode,scenario,agents', '`train --log`'),
           RECORD: ('episode,scenario,agent', '`train` or `evaluate --record`'),
           TRAJECTORIES: (','.join(HEADER), '`evaluate --trajectories`')}


@dataclasses.dataclass(frozen=True)
class Source:
    """A file of a report. Files with the same label are runs of the same thing, such as seeds."""
    label: str
    kind: str
    file: pathlib.Path


def source_of(word):
    """Returns the Source of a word of the command line, [LABEL=]FILE. The default label is the name of the file's
    folder. Raises InputError, OSError."""
    label, name = labelled(word)
    file = pathlib.Path(name)
    with open(file, encoding='utf-8', errors='replace') as stream:
        first = next(stream, '').strip()
    for kind, (header, _) in HEADERS.items():
        if first.startswith(header):
            return Source(file.resolve().parent.name if label is None else label, kind, file)
    expected = ', '.join(f'{header}... ({program})' for header, program in HEADERS.values())
    raise InputError(f'{file}:1: expected one of the headers {expected}')


def columns_of(source):
    """Returns the columns of a file of metrics or of a record, by name. Raises InputError."""
    columns = read_csv(source.file)
    if not columns['scenario']:
        raise InputError(f'{source.file}: has no rows')
    return columns


def of_kind(sources, kind):
    """Returns the sources of a kind, as lists by label in the order of the labels."""
    found = {}
    for source in sources:
        if source.kind == kind:
            found.setdefault(source.label, []).append(source)
    return found
