"""The files of a report, recognised by their headers, and its tables: metrics, and differences of runs with their
confidence intervals."""
import pathlib
import typing

import numpy
import pandas
from crowd_drawing.errors import InputError, opened
from crowd_drawing.files import HEADER
from crowd_experiments.arguments import labelled
from crowd_experiments.records import bootstrap_difference, mean_interval, read_csv

METRICS, LOG, RECORD, ROBOTS, TRAJECTORIES = 'metrics', 'log', 'record', 'robots', 'trajectories'
# First columns, by kind; those of a log begin with those of a record.
HEADERS = {METRICS: ('scenario,instances,success_pct', '`evaluate --csv`'),
           LOG: ('episode,scenario,agents', '`train --log`'),
           RECORD: ('episode,scenario,agent', '`train` or `evaluate --record`'),
           ROBOTS: ('episode,scenario,robot,success', '`evaluate --robots-csv`'),
           TRAJECTORIES: (','.join(HEADER), '`evaluate --trajectories`')}
# Column of `evaluate --csv`, title, decimals.
METRIC_COLUMNS = [('success_pct', 'success [%]', 1), ('contact_pct', 'contact [%]', 1),
                  ('collision_pct', 'collision [%]', 1), ('path_ratio', 'path', 3), ('time_ratio', 'time', 3),
                  ('turn_rad_per_m', 'turning [rad/m]', 2), ('blocked_per_agent', 'blocked', 2)]
# Column of a record, title, factor, decimals.
MEASURES = [('arrived', 'success [%]', 100, 1), ('touched', 'contact [%]', 100, 1),
            ('collided', 'collision [%]', 100, 1), ('path_ratio', 'path', 1, 3), ('time_ratio', 'time', 1, 3),
            ('turn_per_metre', 'turning [rad/m]', 1, 2)]
# Column of a record of robots (docs/metrics.md), title, factor, decimals.
ROBOT_COLUMNS = [('success', 'success [%]', 100, 1), ('spl', 'SPL', 1, 2), ('stl', 'STL', 1, 2),
                 ('time_to_reach_goal', 'time [s]', 1, 1), ('failures_to_progress', 'failures to progress', 1, 2),
                 ('people_contacts', 'contacts: people', 1, 2), ('wall_contacts', 'walls', 1, 2),
                 ('minimum_distance_to_people', 'least distance to people [m]', 1, 2),
                 ('minimum_time_to_collision', 'least time to collision [s]', 1, 2),
                 ('space_compliance', 'space compliance', 1, 2),
                 ('personal_space_intrusions', 'personal space [%]', 1, 1),
                 ('max_acceleration', 'acceleration [m/s²]', 1, 2),
                 ('social_work', 'social work', 1, 2), ('people_delay', "people's delay [s]", 1, 2)]
OF_ALL = ('arrived', 'touched', 'collided')  # the others are those of people who have arrived, as in the metrics


class Source(typing.NamedTuple):
    """A file of a report. Files with the same label are runs of the same thing, such as seeds."""
    label: str
    kind: str
    file: pathlib.Path


def source_of(word):
    """Returns the Source of a word [LABEL=]FILE; the default label is the folder's name. Raises InputError, OSError."""
    label, name = labelled(word)
    file = pathlib.Path(name)
    with opened(file) as stream:
        first = next(stream, '').strip()
    for kind, (header, _) in HEADERS.items():
        if first.startswith(header):
            return Source(file.resolve().parent.name if label is None else label, kind, file)
    expected = ', '.join(f'{header}... ({program})' for header, program in HEADERS.values())
    raise InputError(f'{file}:1: expected one of the headers {expected}')


def columns_of(source):
    """Returns a file of metrics or of a record as a table. Raises InputError."""
    columns = pandas.DataFrame(read_csv(source.file))
    if columns.empty:
        raise InputError(f'{source.file}: has no rows')
    return columns


def of_kind(sources, kind):
    """Returns the sources of a kind, as lists by label in the order of the labels."""
    found = {}
    for source in sources:
        if source.kind == kind:
            found.setdefault(source.label, []).append(source)
    return found


def metrics_rows(groups):
    """Returns header and rows of the table of metrics, with the mean over several files of a label."""
    rows = []
    for label, sources in groups.items():
        for scenario, values in pandas.concat(map(columns_of, sources)).groupby('scenario', sort=False):
            cells = [metric_cell(values.get(column, pandas.Series(dtype=float)), decimals)
                     for column, _, decimals in METRIC_COLUMNS]
            rows.append([label, scenario, str(len(sources)), *cells])
    return ['', 'scenario', 'runs', *(title for _, title, _ in METRIC_COLUMNS)], rows


def robot_rows(groups):
    """Returns header and rows of the table of robots, with the means over all episodes of a label."""
    rows = []
    for label, sources in groups.items():
        records = pandas.concat(map(columns_of, sources))
        for (scenario, robot), values in records.groupby(['scenario', 'robot'], sort=False):
            cells = [metric_cell(factor * values.get(column, pandas.Series(dtype=float)), decimals)
                     for column, _, factor, decimals in ROBOT_COLUMNS]
            rows.append([label, scenario, robot, str(len(values)), *cells])
    return ['', 'scenario', 'robot', 'episodes', *(title for _, title, _, _ in ROBOT_COLUMNS)], rows


def robot_field_rows(groups):
    """Returns header and rows of all numbers of the records of robots, in their order, with the means over all
    episodes of each label."""
    named = ['episode', 'scenario', 'robot']
    records = [pandas.concat(map(columns_of, sources)).drop(columns=named) for sources in groups.values()]
    numbers = [values.select_dtypes('number') for values in records]
    fields = list(dict.fromkeys(field for values in numbers for field in values))
    rows = [[field, *(metric_cell(values.get(field, pandas.Series(dtype=float)), 3) for values in numbers)]
            for field in fields]
    return ['field', *groups], rows


def metric_cell(values, decimals):
    mean, low, _ = mean_interval(values[numpy.isfinite(values)])
    if not numpy.isfinite(mean):
        return '-'
    return f'{mean:.{decimals}f}' + (f' ± {mean - low:.{decimals}f}' if numpy.isfinite(low) else '')


def samples(sources, scenario, column):
    """Returns independent values of a column: means of files if there are several, else of the episodes of the file."""
    episodes = []
    for source in sources:
        rows = columns_of(source)
        if column in rows:
            rows = rows[(rows['scenario'] == scenario) & numpy.isfinite(rows[column])]
            chosen = rows if column in OF_ALL else rows[rows['arrived'] > 0]
            episodes.append(chosen.groupby('episode')[column].mean().tolist())
    if len(episodes) == 1:
        return episodes[0]
    return [float(numpy.mean(means)) for means in episodes if means]


def comparison_rows(groups):
    """Returns header and rows of the comparison of all labels with the first one."""
    labels, rows = list(groups), []
    scenarios = list(dict.fromkeys(name for source in groups[labels[0]] for name in columns_of(source)['scenario']))
    for label in labels[1:]:
        for scenario in scenarios:
            for column, title, factor, decimals in MEASURES:
                first, second = (factor * numpy.array(samples(groups[name], scenario, column))
                                 for name in (labels[0], label))
                if len(first) and len(second):
                    means = [f'{values.mean():.{decimals}f}' for values in (first, second)]
                    difference, *ends = bootstrap_difference(first, second)
                    known = min(len(first), len(second)) > 1
                    interval = ' to '.join(f'{end:+.{decimals}f}' for end in ends) if known else 'unknown: one value'
                    differs = ('no' if ends[0] <= 0 <= ends[1] else 'yes') if known else ''
                    rows.append([label, scenario, title, *means, f'{difference:+.{decimals}f}', interval, differs])
    return ['', 'scenario', '', labels[0], 'this', 'difference', '95 % interval', 'differs'], rows
