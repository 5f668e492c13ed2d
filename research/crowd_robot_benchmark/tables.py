"""Tables of the benchmark of robots."""
import math

from crowd_experiments.pages import Chapter

from .catalogue import CROWDNAV_ORCA, INVISIBLE, VISIBLE
from .measures import Summary, interval, joined, rows_of

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
