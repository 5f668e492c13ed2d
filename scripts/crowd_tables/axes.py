"""Arranges the rows of a Q-table in panels, and labels the axes."""
import math
import textwrap

import numpy

MOST_LABELS = 26  # of an axis
TEXT_WIDTH = 150  # [characters]


def arranged(meaning, numbers):
    """Returns numbers, one for each row of a table, as an array (panel, y, x); rows without a place are left out."""
    places = [index_of(meaning, axis) for axis in (meaning.panels, meaning.rows, meaning.columns)]
    pictures = numpy.full([sizes(meaning, axis) for axis in (meaning.panels, meaning.rows, meaning.columns)], numpy.nan)
    pictures[tuple(places)] = numbers[:len(meaning.digits)]
    return pictures


def sizes(meaning, axis):
    """Returns the number of combinations of the quantities of an axis."""
    return math.prod(len(meaning.quantities[i]) for i in axis)


def index_of(meaning, axis):
    """Returns the position along an axis of each row of the table."""
    index = numpy.zeros(len(meaning.digits), dtype=int)
    for i in axis:
        index = index * len(meaning.quantities[i]) + meaning.digits[:, i]
    return index


def levels_of(meaning, axis):
    """Returns the outer quantities of an axis of which all classes can be labelled, as (quantity, labels, cells of one
    label), outer ones first; at least one."""
    levels, total, labels = [], sizes(meaning, axis), 1
    for i in axis:
        quantity = meaning.quantities[i]
        labels *= len(quantity)
        if levels and labels > MOST_LABELS:
            break
        levels.append((quantity, quantity.classes * (labels // len(quantity)), total // labels))
    return levels[:2]


def label_axes(axes, meaning, with_rows=True):
    """Labels the outer quantities of both axes, and draws lines between the classes of the outermost ones."""
    axes.grid(False)
    for axis, line, chosen in ((axes.xaxis, axes.axvline, meaning.columns), (axes.yaxis, axes.axhline, meaning.rows)):
        quantity, labels, cells = levels_of(meaning, chosen)[0]
        for i in range(1, len(labels)):
            line(i * cells - 0.5, color='white', linewidth=1.2 if cells > 1 else 0.3)
        axis.set_ticks([(i + 0.5) * cells - 0.5 for i in range(len(labels))])
        if axis is axes.xaxis:
            is_long = max(map(len, labels)) * len(labels) > 60
            axes.set_xticklabels(labels, fontsize=8, rotation=40 if is_long else 0, ha='right' if is_long else 'center',
                                 rotation_mode='anchor' if is_long else 'default')
            axes.set_xlabel(quantity.name, fontsize=9)
        else:
            axes.set_yticklabels(labels if with_rows else [], fontsize=8)
            axes.set_ylabel(quantity.name if with_rows else '', fontsize=9)
    axes.tick_params(length=2)
    add_inner_labels(axes, meaning)


def add_inner_labels(axes, meaning):
    """Labels the second quantity of the columns above the picture, if there is room."""
    levels = levels_of(meaning, meaning.columns)
    if meaning.panels or len(levels) < 2:
        return
    quantity, labels, cells = levels[1]
    above = axes.secondary_xaxis('top')
    above.set_ticks([(i + 0.5) * cells - 0.5 for i in range(len(labels))])
    above.set_xticklabels(labels, fontsize=7, rotation=60)
    above.set_xlabel(quantity.name, fontsize=9)
    above.tick_params(length=2)


def explanation(meaning):
    """Returns how to read the picture: the quantities of both axes with their classes, outer ones first."""
    lines = []
    for title, axis in (('Panels', meaning.panels), ('From top to bottom', meaning.rows),
                        ('From left to right', meaning.columns)):
        parts = [f"{meaning.quantities[i].name} ({'; '.join(meaning.quantities[i].classes)})"
                 if len(meaning.quantities[i]) <= 9 else meaning.quantities[i].name for i in axis]
        if axis:
            lines += textwrap.wrap(f"{title}: {', within each of these '.join(shortened(parts))}.", TEXT_WIDTH,
                                   subsequent_indent='    ')
    return '\n'.join(lines)


def shortened(parts):
    """Leaves out the classes in brackets that are the same as those of the quantity before."""
    kept = []
    for i, part in enumerate(parts):
        name, bracket, classes = part.partition(' (')
        before = parts[i - 1].partition(' (')[2] if i else ''
        kept.append(name if classes and classes == before else name + bracket + classes)
    return kept
