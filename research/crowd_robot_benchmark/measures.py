"""Scenarios and robots of the benchmark; measures of episodes of one robot, from records of `evaluate --robots-csv`,
and their tables."""
import math
import typing

import numpy
import pandas
from crowd_drawing.errors import InputError
from crowd_experiments.pages import Chapter
from crowd_experiments.records import read_csv
from crowd_experiments.runs import RunError
from scipy.stats import binomtest

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
ROS_PLACEMENTS = 5  # the same for robots that are driven through ROS
# CrowdNav's setting: a circle of 4 m, five people, bodies of 0.3 m, 1 m/s, 25 s.
CROWDNAV = 'robot_circle_5'
CROWDNAV_EPISODES = 500
VISIBLE, INVISIBLE = 'visible', 'invisible'
CROWDNAV_KEYS = {VISIBLE: {}, INVISIBLE: {'perceived': False}}
# Published results of ORCA as the robot among people that walk by ORCA: episodes that it reached its goal without a
# contact, episodes with a contact, and the mean time of the former [s].
CROWDNAV_ORCA = {VISIBLE: (500, 0, 10.02), INVISIBLE: (213, 284, 10.86)}

CAUSES = ['robot_on_person_collisions', 'person_on_robot_collisions', 'mutual_collisions']
NEEDED = ['episode', 'scenario', 'robot', 'success', 'time_to_reach_goal', *CAUSES, 'personal_space_time']
# Of `evaluate --people-delay` only: a run through ROS has no run without robots to compare with.
PEOPLE = {'people_compared': 0.0, 'people_delay': math.nan, 'people_detour': math.nan}
HEADER = ['success', 'success without contact', 'contacts: robot on person, person on robot, mutual', 'time [s]',
          'personal space [s]', "people's delay [s]", 'detour [m]']


def read_record(file):
    """Returns a record of robots. Raises RunError if it is not one, OSError."""
    try:
        record = pandas.DataFrame(read_csv(file))
    except InputError as error:
        raise RunError(f'{file}: expected a record of robots as CSV, got something else ({error})') from error
    missing = [name for name in NEEDED if name not in record]
    if missing:
        raise RunError(f'{file}: expected a record as of `evaluate --robots-csv`, got one without the columns '
                       f'{", ".join(missing)}')
    return record.assign(**{name: value for name, value in PEOPLE.items() if name not in record})


def rows_of(record, scenario):
    return record[record['scenario'] == scenario]


class Summary(typing.NamedTuple):
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
        success, touched = record['success'] > 0, record[CAUSES].sum(axis=1) > 0
        time = record['time_to_reach_goal']
        known = record[record['people_compared'] > 0]
        of_people = [float(numpy.average(known[column], weights=known['people_compared'])) if len(known) else math.nan
                     for column in ('people_delay', 'people_detour')]
        return cls(len(record), int(success.sum()), int((success & ~touched).sum()), int(touched.sum()),
                   tuple(record[CAUSES].sum().astype(int)), time[success].mean(), time[success & ~touched].mean(),
                   record['personal_space_time'].mean(), *of_people)

    def cells(self):
        return [share_text(self.arrived, self.episodes), share_text(self.clean, self.episodes),
                ', '.join(map(str, self.contacts)), number_text(self.time, 1),
                number_text(self.personal_space_time, 1), number_text(self.people_delay, 2),
                number_text(self.people_detour, 2)]


def interval(count, total):
    """Returns the 95 % interval of a share of which `count` of `total` were observed: Wilson's score interval."""
    return tuple(binomtest(count, total).proportion_ci(method='wilson')) if total else (0.0, 1.0)


def chapter_of(records, scenarios, crowdnav):
    """Returns the tables `robots/summary`, `robots/scenarios` and `robots/crowdnav`.

    @param records by robot, with the rows of all scenarios
    @param crowdnav by (robot, VISIBLE or INVISIBLE): records in CrowdNav's setting"""
    chapter = Chapter('robots', 'Robots among people')
    summary, single = [], []
    for robot, record in records.items():
        parts = {name: rows_of(record, name) for name in scenarios if (record['scenario'] == name).any()}
        if parts:
            low, high = (extreme(map(len, parts.values())) for extreme in (min, max))
            episodes = f'{len(parts)} x {low}' + (f'-{high}' if low != high else '')
            summary.append([robot, episodes, *Summary.of(pandas.concat(parts.values())).cells()])
            single += [[name, robot, *Summary.of(rows).cells()] for name, rows in parts.items()]
    single.sort(key=lambda row: scenarios.index(row[0]))
    if summary:
        chapter.add_table('All scenarios', ['robot', 'episodes', *HEADER], summary, 'summary')
        chapter.add_table('By scenario', ['scenario', 'robot', *HEADER], single, 'scenarios')
    if crowdnav:
        chapter.add_table("CrowdNav's setting", ['people', 'robot', 'episodes', 'success', 'contact', 'neither',
                                                 'time [s]'], crowdnav_rows(crowdnav), 'crowdnav')
    return chapter


def crowdnav_rows(crowdnav):
    """Returns a row for each robot, and for ORCA as published. Success is as in CrowdNav without a contact."""
    rows = []
    for kind, (clean, touched, time) in CROWDNAV_ORCA.items():
        found = [('ORCA, published', clean, touched, 500, time)]
        for robot, summary in ((robot, Summary.of(record)) for (robot, one), record in crowdnav.items() if one == kind):
            found.append((robot, summary.clean, summary.touched, summary.episodes, summary.clean_time))
        rows += [[f'robot {kind}', robot, str(episodes), share_text(clean, episodes), share_text(touched, episodes),
                  str(episodes - clean - touched), number_text(time, 2)]
                 for robot, clean, touched, episodes, time in found]
    return rows


def share_text(count, total):
    """Returns a count with the 95 % interval of its share, such as `213 (38-47 %)`."""
    low, high = interval(count, total)
    return f'{count} ({math.floor(100 * low + 0.5)}-{math.floor(100 * high + 0.5)} %)'


def number_text(value, decimals):
    """Returns a number; `-` for nan, and no sign for zero."""
    return '-' if math.isnan(value) else f'{round(value, decimals) + 0.0:.{decimals}f}'
