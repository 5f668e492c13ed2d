"""Measures of episodes of one robot, from records of `evaluate --robots-csv`, and their tables."""
import dataclasses
import math

import numpy
from crowd_drawing.errors import InputError
from crowd_experiments.pages import Chapter
from crowd_experiments.records import read_csv
from crowd_experiments.runs import RunError


HEADER = ['success', 'success without contact', 'contacts: robot on person, person on robot, mutual', 'time [s]',
          'personal space [s]', "people's delay [s]", 'detour [m]']


def chapter_of(records, scenarios, crowdnav):
    """Returns the tables `robots/summary`, `robots/scenarios` and `robots/crowdnav`.

    @param records by robot, with the rows of all scenarios
    @param crowdnav by (robot, VISIBLE or INVISIBLE): records in CrowdNav's setting"""
    chapter = Chapter('robots', 'Robots among people')
    summary, single = [], []
    for robot, record in records.items():
        parts = {name: rows_of(record, name) for name in scenarios}
        parts = {name: rows for name, rows in parts.items() if len(rows['success'])}
        if not parts:
            continue
        whole = Summary.of(joined(parts.values()))
        summary.append([robot, f'{len(parts)} x {text_of_episodes(parts)}', *cells(whole)])
        single += [[name, robot, *cells(Summary.of(rows))] for name, rows in parts.items()]
    single.sort(key=lambda row: scenarios.index(row[0]))
    if summary:
        chapter.add_table('All scenarios', ['robot', 'episodes', *HEADER], summary, 'summary')
        chapter.add_table('By scenario', ['scenario', 'robot', *HEADER], single, 'scenarios')
    if crowdnav:
        chapter.add_table("CrowdNav's setting", ['people', 'robot', 'episodes', 'success', 'contact', 'neither',
                                                 'time [s]'], crowdnav_rows(crowdnav), 'crowdnav')
    return chapter


def text_of_episodes(parts):
    """Returns the number of episodes of a scenario, such as 20 or 18-20."""
    numbers = [len(rows['success']) for rows in parts.values()]
    return f'{min(numbers)}' if min(numbers) == max(numbers) else f'{min(numbers)}-{max(numbers)}'


def cells(summary):
    """Returns the cells of a row, without its names."""
    return [share_text(summary.arrived, summary.episodes), share_text(summary.clean, summary.episodes),
            ', '.join(map(str, summary.contacts)), number_text(summary.time, 1),
            number_text(summary.personal_space_time, 1), number_text(summary.people_delay, 2),
            number_text(summary.people_detour, 2)]


def crowdnav_rows(crowdnav):
    """Returns a row for each robot, and for ORCA as published. Success is as in CrowdNav without a contact."""
    rows = []
    for kind in (VISIBLE, INVISIBLE):
        clean, touched, time = CROWDNAV_ORCA[kind]
        rows.append([f'robot {kind}', 'ORCA, published', *crowdnav_cells(clean, touched, 500, time)])
        for (robot, of_kind), record in crowdnav.items():
            if of_kind == kind:
                found = Summary.of(record)
                rows.append([f'robot {kind}', robot,
                             *crowdnav_cells(found.clean, found.touched, found.episodes, found.clean_time)])
    return rows


def crowdnav_cells(clean, touched, episodes, time):
    return [str(episodes), share_text(clean, episodes), share_text(touched, episodes),
            str(episodes - clean - touched), number_text(time, 2)]


def share_text(count, total):
    """Returns a count with the 95 % interval of its share, such as `213 (38-47 %)`."""
    low, high = interval(count, total)
    return f'{count} ({math.floor(100 * low + 0.5)}-{math.floor(100 * high + 0.5)} %)'


def number_text(value, decimals):
    """Returns a number; `-` for nan, and no sign for zero."""
    return '-' if math.isnan(value) else f'{round(value, decimals) + 0.0:.{decimals}f}'

SCENARIOS = ('robot_corridor_with', 'robot_corridor_against', 'robot_crossing', 'robot_overtaking', 'robot_door',
             'robot_corner', 'robot_circle_5', 'robot_circle_20', 'robot_circle_50', 'robot_hall', 'robot_queue',
             'robot_station')
# Robots that are run here: the controller of `evaluate --robot`, and the keys that change in the robots of a scenario.
ROBOTS = {
    'straight': ('straight', {}),
    'reactive': ('reactive', {}),
    'learned': ('learned', {}),
    'straight_stop': ('straight', {'yields': 'both'}),  # with protective stop
    'learned_stop': ('learned', {'yields': 'both'}),
}
PLACEMENTS = 20  # episodes of each scenario
ROS_PLACEMENTS = 5  # the same for DRIVEN

# CrowdNav's setting: a circle of 4 m, five people, bodies of 0.3 m, 1 m/s, 25 s.
CROWDNAV = 'robot_circle_5'
CROWDNAV_EPISODES = 500
VISIBLE, INVISIBLE = 'visible', 'invisible'
CROWDNAV_KEYS = {VISIBLE: {}, INVISIBLE: {'perceived': False}}
# Published results of ORCA as the robot among people that walk by ORCA: episodes that it reached its goal without a
# contact, episodes with a contact, and the mean time of the former [s].
CROWDNAV_ORCA = {VISIBLE: (500, 0, 10.02), INVISIBLE: (213, 284, 10.86)}


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
