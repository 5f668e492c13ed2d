"""Figures of a run: the rates and ratios of section 4.1 of the thesis."""
import contextlib
import os

import numpy
from crowd_experiments.pages import Table
from crowd_experiments.records import path_per_gain, percent, read_csv
from social_crowd.msg import AgentResult

SCENE = 'scene.yaml'  # the crowd's first episode, with all values that were drawn
TRAJECTORIES = 'trajectories'  # folder: a scenario may have the name of a record
NOT_RECORDED = 'agent', 'removed', 'max_speed_ratio'  # fields of results that records do not have, or name first


def write_record(file, results):
    """Writes a CSV file with the columns of `train --record` and `evaluate --record`."""
    fields = [name for name in AgentResult.__slots__ if name not in NOT_RECORDED]
    with open(file, 'w', encoding='utf-8') as stream:
        stream.write(','.join(['episode', 'scenario', 'agent', *fields]) + '\n')
        for episode, result in enumerate(results):
            for agent in result.agents:
                if not agent.removed:
                    numbers = [repr(float(value)) if isinstance(value, float) else str(int(value))
                               for value in (getattr(agent, name) for name in fields)]
                    stream.write(','.join([str(episode), result.scenario, str(agent.agent), *numbers]) + '\n')


FIGURES = [
    ('episodes', lambda rows: f'{len(numpy.unique(rows["episode"]))}'),
    ('agents', lambda rows: f'{len(numpy.unique(rows["agent"]))}'),
    ('success [%]', lambda rows: f'{percent(rows["arrived"]):.1f}'),
    ('collision [%]', lambda rows: f'{percent(rows["collided"]):.1f}'),
    ('contact [%]', lambda rows: f'{percent(rows["touched"]):.1f}'),
    ('distance gained per step [m]', lambda rows: f'{float(numpy.median(rows["gain_per_tick"])):.4f}'),
    ('path per distance gained', lambda rows: f'{path_per_gain(rows):.3f}'),
]


def table_of(title, records):
    """Returns a table of all figures. Records: [(title of a column, file)]."""
    columns = {column: read_csv(file) for column, file in records}
    return Table(title, ['', *columns],
                 [[name, *(text_of(rows) for rows in columns.values())] for name, text_of in FIGURES])


def draw(plan, curves, scenario):
    """Draws the learning curves and the walked paths of the crowd's first episode. Curves: [(title, file)]. Returns
    the files of the pictures."""
    from crowd_curves import program as learning  # where it is needed: matplotlib takes time to be loaded
    from crowd_drawing import paths_program as paths
    files = plan.file('learning.png'), plan.file('paths.png')
    with open(os.devnull, 'w', encoding='utf-8') as nowhere, contextlib.redirect_stdout(nowhere):
        learning.main([*(f'{title}={file}' for title, file in curves), '--output', files[0]])
        paths.main(['--trajectories', plan.file(f'{TRAJECTORIES}/{scenario}.csv'), '--scenario', plan.file(SCENE),
                    '--output', files[1]])
    return files
