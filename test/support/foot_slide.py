#!/usr/bin/python3
"""Measures how far feet slide in files of `export`: foot_slide.py FILE.glb FILE.csv prints their way in a stance."""
import csv
import sys

import numpy
from crowd_figures.skeleton import ANKLE, HEEL, TOE
from glb import Glb

FINER = 4  # moments in a frame: between keyframes, too
LEVEL = 0.003  # heel and toes that differ less in height are both on the floor [m]


def rows_of(file):
    """Returns the rows of a CSV file by person."""
    people = {}
    with open(file, encoding='utf-8') as stream:
        for row in csv.DictReader(stream):
            people.setdefault(row['person'], []).append(row)
    return people


def feet_of(glb, person, rows):
    """Yields for both feet whether they stand in each frame, and at FINER moments in a frame the height of the lowest
    point and how far the point on the floor moves to the next moment [m]."""
    node, times = glb.named(person), numpy.array([float(row['time']) for row in rows])
    times = numpy.interp(numpy.arange(FINER * (len(times) - 1) + 1) / FINER, numpy.arange(len(times)), times)
    for side in ('left', 'right'):
        foot = glb.world(glb.below(node, f'{side}_foot'), times)
        ends = numpy.array([(foot @ [0, -ANKLE, ahead, 1])[:, :3] for ahead in (HEEL, TOE)])
        heights = ends[:, :, 1].min(axis=0)
        moves = numpy.linalg.norm(numpy.diff(ends[:, :, [0, 2]], axis=1), axis=2)
        is_low = ends[:, 1:, 1] < heights[1:] + LEVEL
        yield (numpy.array([row[f'{side}_stands'] == '1' for row in rows]), heights,
               numpy.where(is_low, moves, numpy.inf).min(axis=0))


def stances(stands):
    """Returns first and last frame of each stance."""
    edges = numpy.flatnonzero(numpy.diff(numpy.r_[0, stands, 0].astype(int)))
    return [(begin, end - 1) for begin, end in zip(edges[::2], edges[1::2])]


def slides_of(stands, moves):
    """Returns the way of the point on the floor in each stance [m]."""
    return [moves[FINER * begin:FINER * end].sum() for begin, end in stances(stands)]


if __name__ == '__main__':
    FILE, SLIDES = Glb(sys.argv[1]), []
    for name, table in rows_of(sys.argv[2]).items():
        if table[0]['left_x']:
            SLIDES += [slide for stands, _, moves in feet_of(FILE, name, table) for slide in slides_of(stands, moves)]
    print('{} stances, mean {:.1f} mm, 99 % below {:.1f} mm'.format(
        len(SLIDES), 1000 * numpy.mean(SLIDES), 1000 * numpy.percentile(SLIDES, 99)))
