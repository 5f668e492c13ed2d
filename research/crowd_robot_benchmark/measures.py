"""Measures of episodes of one robot, from records of `evaluate --robots-csv`, and their tables."""
import math
import typing

import numpy
import pandas
from crowd_drawing.errors import InputError
from crowd_experiments.pages import Chapter
from crowd_experiments.records import read_csv
from crowd_experiments.runs import RunError
from scipy.stats import binomtest

from .suite import INVISIBLE, VISIBLE

# Published results of ORCA as the robot among people that walk by ORCA: episodes that it reached its goal without a
# contact, episodes with a contact, and the mean time of the former [s].
CROWDNAV_ORCA = {VISIBLE: (500, 0, 10.02), INVISIBLE: (213, 284, 10.86)}

CONTACTS = 'people_contacts'  # sum of CAUSES
CAUSES = ['robot_on_person_collisions', 'person_on_robot_collisions', 'mutual_collisions']
NEEDED = ['episode', 'scenario', 'robot', 'success', 'time_to_reach_goal', CONTACTS, *CAUSES, 'personal_space_time']
# Of `evaluate --people-delay` only: a run through ROS has no run without robots to compare with.
PEOPLE = {'people_compared': 0.0, 'people_delay': math.nan, 'people_detour': math.nan}
DENSITY = 'people_density'  # [1/m2]; of records that have it
SPL = 'spl'  # the same
HEADER = ['success', 'success without contact', 'SPL', 'contacts: robot on person, person on robot, mutual', 'time [s]',
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
    spl: float  # mean success weighted by path length
    contacts: tuple  # by CAUSES
    time: float  # mean of the episodes in which it arrived [s]
    clean_time: float  # mean of those without a contact [s]
    personal_space_time: float  # mean of all [s]
    people_delay: float  # mean of all people that were compared [s]
    people_detour: float  # [m]

    @classmethod
    def of(cls, record):
        success, touched = record['success'] > 0, record[CONTACTS] > 0
        time = record['time_to_reach_goal']
        known = record[record['people_compared'] > 0]
        of_people = [float(numpy.average(known[column], weights=known['people_compared'])) if len(known) else math.nan
                     for column in ('people_delay', 'people_detour')]
        return cls(len(record), int(success.sum()), int((success & ~touched).sum()), int(touched.sum()),
                   record[SPL].mean() if SPL in record else math.nan, tuple(record[CAUSES].sum().astype(int)),
                   time[success].mean(), time[success & ~touched].mean(),
                   record['personal_space_time'].mean(), *of_people)

    def cells(self):
        return [share_text(self.arrived, self.episodes), share_text(self.clean, self.episodes),
                number_text(self.spl, 2), ', '.join(map(str, self.contacts)), number_text(self.time, 1),
                number_text(self.personal_space_time, 1), number_text(self.people_delay, 2),
                number_text(self.people_detour, 2)]


def interval(count, total):
    """Returns the 95 % interval of a share of which `count` of `total` were observed: Wilson's score interval."""
    return tuple(binomtest(count, total).proportion_ci(method='wilson')) if total else (0.0, 1.0)


def chapter_of(records, scenes, crowdnav):
    """Returns the tables `robots/summary`, `robots/scenes` and `robots/crowdnav`.

    @param records by robot, with the rows of all scenes
    @param crowdnav by (robot, VISIBLE or INVISIBLE): records in CrowdNav's setting"""
    chapter = Chapter('robots', 'Robots among people')
    parts = {robot: {name: rows_of(record, name) for name in scenes if (record['scenario'] == name).any()}
             for robot, record in records.items()}
    parts = {robot: of_robot for robot, of_robot in parts.items() if of_robot}
    if parts:
        chapter.add_table('All scenes', ['robot', 'episodes', *HEADER],
                          [summary_row(robot, of_robot) for robot, of_robot in parts.items()], 'summary')
        chapter.add_table('By scene: robots that arrived / without contact', ['scene', 'people per m²', *parts],
                          scene_rows(parts, scenes), 'scenes')
    if crowdnav:
        chapter.add_table("CrowdNav's setting", ['people', 'robot', 'episodes', 'success', 'contact', 'neither',
                                                 'time [s]'], crowdnav_rows(crowdnav), 'crowdnav')
    return chapter


def summary_row(robot, of_robot):
    """Returns the row of a robot, given its records by scene."""
    low, high = (extreme(map(len, of_robot.values())) for extreme in (min, max))
    episodes = f'{len(of_robot)} x {low}' + (f'-{high}' if low != high else '')
    return [robot, episodes, *Summary.of(pandas.concat(of_robot.values())).cells()]


def scene_rows(parts, scenes):
    """Returns a row for each scene that any robot was measured in."""
    rows = []
    for scene in scenes:
        of_scene = {robot: of_robot[scene] for robot, of_robot in parts.items() if scene in of_robot}
        if not of_scene:
            continue
        cells = [f'{summary.arrived} / {summary.clean}' if summary else '-' for summary in
                 (Summary.of(of_scene[robot]) if robot in of_scene else None for robot in parts)]
        rows.append([scene, density_text(of_scene.values()), *cells])
    return rows


def density_text(records):
    """Returns the mean density of people in records [1/m2]; `-` where it was not measured."""
    known = [record[DENSITY] for record in records if DENSITY in record]
    return number_text(pandas.concat(known).mean(), 2) if known else '-'


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
