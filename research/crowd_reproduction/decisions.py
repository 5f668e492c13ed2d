"""Reads the decisions that `evaluate --states` records, and the number of visits of each row of a Q-table."""
import dataclasses

import numpy

HEADER = ['instance', 'tick', 'agent', 'x', 'y', 'heading', 'row', 'action', 'occupied']
NUMBERS = HEADER[:-1]


@dataclasses.dataclass(frozen=True)
class Sector:
    """An occupied sector; angles from straight ahead, positive to the left [degrees]."""
    begin: float
    end: float
    distance_class: int


def read_decisions(file):
    """Returns the columns of a record of decisions by their names: arrays, and the list `occupied` of texts; the array
    `sectors` has the number of occupied sectors."""
    with open(file, encoding='utf-8') as stream:
        if next(stream, '').rstrip('\n').split(',') != HEADER:
            raise ValueError(f"{file}:1: expected the header {','.join(HEADER)}")
        lines = [line.rstrip('\n').rsplit(',', 1) for line in stream]
    numbers = numpy.fromstring(','.join(line[0] for line in lines), sep=',').reshape(-1, len(NUMBERS))
    decisions = {name: column if name in ('x', 'y', 'heading') else column.astype(int)
                 for name, column in zip(NUMBERS, numbers.T)}
    occupied = [line[1] for line in lines]
    sectors = numpy.array([text.count(' ') + 1 if text else 0 for text in occupied], dtype=int)
    return {**decisions, 'occupied': occupied, 'sectors': sectors}


def sectors_of(occupied):
    """Parses the sectors of a record; sectors to the right of straight ahead have negative angles."""
    sectors = [Sector(float(begin), float(end), int(distance_class))
               for begin, end, distance_class in (word.split(':') for word in occupied.split())]
    return [dataclasses.replace(sector, begin=sector.begin - 360, end=sector.end - 360) if sector.end > 180 else sector
            for sector in sectors]


def read_visits(file):
    """Returns the number of visits of each row of a Q-table, as an array."""
    with open(file, encoding='utf-8') as stream:
        next(stream)
        header = dict(line.split(': ', 1) for line in iter(lambda: next(stream), '---\n'))
        visits = numpy.zeros(int(header['rows']), dtype=int)
        for line in stream:
            if line.startswith(('source', 'checksum')):  # the visits of other sources follow
                break
            row, *cells = line.split(' ')
            visits[int(row)] = sum(map(int, cells[::2]))
    return visits
