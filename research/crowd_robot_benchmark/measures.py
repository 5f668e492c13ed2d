"""Measures of episodes of one robot, from a record of `evaluate --robots-csv`."""
import dataclasses
import math

import numpy

from crowd_drawing.errors import InputError
from crowd_experiments.records import read_csv
from crowd_experiments.runs import RunError

NEEDED = ('episode', 'scenario', 'robot', 'success', 'time_to_reach_goal', 'robot_on_person_collisions',
          'person_on_robot_collisions', 'mutual_collisions', 'personal_space_time')
# Of `evaluate --people-delay` only: a run through ROS has no run without robots to compare with.
PEOPLE = {'people_compared': 0.0, 'people_delay': math.nan, 'people_detour': math.nan}
CAUSES = ('robot_on_person_collisions', 'person_on_robot_collisions', 'mutual_collisions')
CONFIDENCE = 1.959964  # standard deviations of a 95 % interval


def read_record(file):
    """Returns the columns of a record of robots by their names. Raises RunError if it is not one."""
    try:
        record = read_csv(file)
    except InputError as error:
        raise RunError(f'{file}: expected a record of robots as CSV, got something else ({error})') from error
    missing = [name for name in NEEDED if name not in record]
    if missing:
        raise RunError(f'{file}: expected a record as of `evaluate --robots-csv`, got one without the columns '
                       f'{", ".join(missing)}')
    for name, without in PEOPLE.items():
        record.setdefault(name, numpy.full(len(record['episode']), without))
    return record


def rows_of(record, scenario):
    """Returns the rows of a record that belong to a scenario."""
    rows = numpy.array([name == scenario for name in record['scenario']], dtype=bool)
    return {name: numpy.array(column)[rows] for name, column in record.items()}


def joined(records):
    """Returns the rows of several records as one."""
    return {name: numpy.concatenate([numpy.array(record[name]) for record in records])
            for name in (*NEEDED, *PEOPLE)}


@dataclasses.dataclass(frozen=True)
class Summary:
    """Results of many episodes. Means are nan if there is nothing to take the mean of."""
    episodes: int
    arrived: int
    clean: int  # arrived without a contact with people
    touched: int  # episodes with a contact
    contacts: tuple  # by CAUSES
    time: float  # mean of the episodes in which it arrived [s]
    clean_time: float  # mean of those without a contact [s]
    personal_space_time: float  # mean of all [s]
    people_delay: float  # mean of all people that were compared [s]
    people_detour: float  # [m]

    @classmethod
    def of(cls, record):
        """Sums up a record."""
        success = record['success'] > 0
        contacts = sum(record[cause] for cause in CAUSES)
        clean = success & (contacts == 0)
        people = record['people_compared']
        known = people > 0

        def of_people(column):
            return float(numpy.average(record[column][known], weights=people[known])) if known.any() else math.nan
        return cls(len(success), int(success.sum()), int(clean.sum()), int((contacts > 0).sum()),
                   tuple(int(record[cause].sum()) for cause in CAUSES), mean(record['time_to_reach_goal'][success]),
                   mean(record['time_to_reach_goal'][clean]), mean(record['personal_space_time']),
                   of_people('people_delay'), of_people('people_detour'))


def mean(values):
    """Returns the mean; nan without values."""
    return float(numpy.mean(values)) if len(values) else math.nan


def interval(count, total):
    """Returns the 95 % interval of a share of which `count` of `total` were observed: Wilson's score interval."""
    if total == 0:
        return 0.0, 1.0
    square = CONFIDENCE ** 2
    share = count / total
    centre = (share + square / (2 * total)) / (1 + square / total)
    half = CONFIDENCE / (1 + square / total) * math.sqrt(share * (1 - share) / total + square / (4 * total ** 2))
    return max(0.0, centre - half), min(1.0, centre + half)
