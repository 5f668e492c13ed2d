"""Reads the decisions that `evaluate --states` records, and the number of visits of each row of a Q-table."""
import dataclasses
import io

import numpy
import pandas
from crowd_experiments import records

HEADER = ['instance', 'tick', 'agent', 'x', 'y', 'heading', 'row', 'action', 'occupied']


@dataclasses.dataclass(frozen=True)
class Sector:
    """An occupied sector; angles from straight ahead, positive to the left [degrees]."""
    begin: float
    end: float
    distance_class: int


def read_decisions(file):
    """Returns a table of decisions; the column `occupied` has texts, `sectors` the number of occupied sectors."""
    with open(file, encoding='utf-8') as stream:
        if next(stream, '').rstrip('\n').split(',') != HEADER:
            raise ValueError(f"{file}:1: expected the header {','.join(HEADER)}")
        decisions = pandas.read_csv(io.StringIO(stream.read()), names=HEADER, keep_default_na=False, dtype={
            'x': float, 'y': float, 'heading': float, 'occupied': str})
    decisions['sectors'] = decisions['occupied'].str.count(':').floordiv(2)
    return decisions


def sectors_of(occupied):
    """Parses the sectors of a record; sectors to the right of straight ahead have negative angles."""
    sectors = [Sector(float(begin), float(end), int(distance_class))
               for begin, end, distance_class in (word.split(':') for word in occupied.split())]
    return [dataclasses.replace(sector, begin=sector.begin - 360, end=sector.end - 360) if sector.end > 180 else sector
            for sector in sectors]


def read_visits(file):
    """Returns the number of visits of each row of a Q-table, as an array."""
    visits = numpy.zeros(int(records.read_table_header(file)['rows']), dtype=int)
    found = records.read_visits(file)
    visits[list(found)] = list(found.values())
    return visits
