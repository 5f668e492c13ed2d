"""The program `draw_q_table`: a Q-table as heat maps of values and visits, with labelled axes, or a row explained."""
import copy
import math
import pathlib
import textwrap

import numpy
from crowd_drawing.errors import InputError, check_output
from crowd_experiments.arguments import add_file, add_tools, parser_of, whole
from crowd_experiments.style import SETTINGS, save
from crowd_experiments.tools import find_table, find_tools
from crowd_tables.table import action_names, greedy_actions, meaning_of, read_table, row_values, row_visits
from matplotlib import pyplot, rc_context
from matplotlib.colors import LogNorm, Normalize

MOST_LABELS = 26  # of an axis
TEXT_WIDTH = 150  # [characters]
UNVISITED = '0.88'  # colour
OUTLIERS = 2  # [%] of the values at each end that have the colours of the ends
MOST_ARROWS = 400
VALUE_OF = {'anticipation': 'mean value of the row, weighted by visits'}
# Size of a panel [inch], and panels side by side; by state set.
SHAPES = {'nearest_obstacle': (5.6, 6.2, 2), 'anticipation': (15.5, 5.2, 1)}
SHAPE_OF_MANY = (3.5, 3.1, 4)
EXAMPLES = '''examples:
  draw_q_table config/q_tables/thesis_nearest.txt --output nearest.png
  draw_q_table human --row 1234'''
PICTURES = ('.png', '.pdf', '.svg')


def arranged(meaning, numbers):
    """Returns numbers, one for each row of a table, as an array (panel, y, x); rows without a place are left out."""
    axes = meaning.panels, meaning.rows, meaning.columns
    places = [numpy.ravel_multi_index(meaning.digits[:, axis].T, [len(meaning.quantities[i]) for i in axis])
              if axis else 0 for axis in axes]
    pictures = numpy.full([sizes(meaning, axis) for axis in axes], numpy.nan)
    pictures[tuple(places)] = numbers[:len(meaning.digits)]
    return pictures


def sizes(meaning, axis):
    return math.prod(len(meaning.quantities[i]) for i in axis)


def levels_of(meaning, axis):
    """Returns the outer quantities of an axis that can be labelled, as (quantity, labels, cells of one label)."""
    levels, total, labels = [], sizes(meaning, axis), 1
    for i in axis:
        quantity = meaning.quantities[i]
        labels *= len(quantity)
        if levels and labels > MOST_LABELS:
            break
        levels.append((quantity, quantity.classes * (labels // len(quantity)), total // labels))
    return levels[:2]


def label_axes(axes, meaning):
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
            axes.set_yticklabels(labels, fontsize=8)
            axes.set_ylabel(quantity.name, fontsize=9)
    axes.tick_params(length=2)
    levels = levels_of(meaning, meaning.columns)
    if not meaning.panels and len(levels) > 1:  # there is room for the second quantity of the columns above the picture
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
        parts, before = [], None
        for quantity in (meaning.quantities[i] for i in axis):
            # Classes that are the same as those of the quantity before are left out.
            has_classes = len(quantity) <= 9 and quantity.classes != before
            parts.append(quantity.name + (f" ({'; '.join(quantity.classes)})" if has_classes else ''))
            before = quantity.classes
        if axis:
            lines += textwrap.wrap(f"{title}: {', within each of these '.join(parts)}.", TEXT_WIDTH,
                                   subsequent_indent='    ')
    return '\n'.join(lines)


def draw_table(file, table, meaning, title):
    """Draws the values and below, or beside them, the visits of all rows. Returns the file."""
    width, height, columns = SHAPES.get(meaning.type, SHAPE_OF_MANY)
    values = arranged(meaning, row_values(table, meaning.type))
    visits = arranged(meaning, row_visits(table).astype(float))
    visits[visits == 0] = numpy.nan
    rows = -(-2 * len(values) // columns)
    text = explanation(meaning)
    with rc_context(fname=SETTINGS):
        figure = pyplot.figure(figsize=(width * columns, height * rows + 0.2 * text.count('\n') + 1.0),
                               layout='constrained')
        grid = figure.add_gridspec(rows + 1, columns, height_ratios=[height] * rows + [0.2 * text.count('\n') + 0.3])
        panels = [figure.add_subplot(grid[i // columns, i % columns]) for i in range(2 * len(values))]
        draw_pictures(figure, panels[:len(values)], meaning, values, 'viridis', value_scale(values),
                      VALUE_OF.get(meaning.type, 'highest value of a visited action'), 'value')
        scale = LogNorm(1, numpy.nanmax(visits, initial=10.0))
        draw_pictures(figure, panels[len(values):], meaning, visits, 'magma', scale, 'visits', 'visits')
        if meaning.type == 'nearest_obstacle':
            add_arrows(panels[0], table, meaning, values)
        below = figure.add_subplot(grid[rows, :])
        below.set_axis_off()
        below.text(0, 1, text, va='top', fontsize=9, transform=below.transAxes)
        figure.suptitle(title, fontsize=12)
    return save(figure, file)


def value_scale(values):
    known = values[numpy.isfinite(values)]
    if not len(known):
        return Normalize(0, 1)
    low, high = numpy.percentile(known, [OUTLIERS, 100 - OUTLIERS])
    return Normalize(low, high) if high > low else Normalize(low - 1, low + 1)


def draw_pictures(figure, panels, meaning, pictures, colours, scale, title, short):
    """Draws the panels of one kind of number, with a colour bar. `short`: the title where there are many panels."""
    colour_map = copy.copy(pyplot.get_cmap(colours))
    colour_map.set_bad(UNVISITED)
    for i, (axes, picture) in enumerate(zip(panels, pictures)):
        image = axes.imshow(numpy.ma.masked_invalid(picture), cmap=colour_map, norm=scale, aspect='auto',
                            interpolation='nearest')
        label_axes(axes, meaning)
        name = meaning.quantities[meaning.panels[0]].classes[i] if meaning.panels else ''
        axes.set_title(f'{short}, goal {name}' if name else title, fontsize=9 if name else 11)
    extend = 'both' if isinstance(scale, Normalize) and not isinstance(scale, LogNorm) else 'neither'
    bar = figure.colorbar(image, ax=panels, shrink=0.9, pad=0.01, extend=extend)
    bar.set_label(f'{title} (grey: not visited)', fontsize=9)


def add_arrows(axes, table, meaning, values):
    """Draws the greedy action of each visited row of the thesis's moves: up is straight ahead."""
    rotations = table.header['action_set'].get('rotations', 8)
    if table.header['action_set'].get('type') != 'kings_moves' or len(meaning.digits) > MOST_ARROWS:
        return
    greedy, bright = greedy_actions(table), value_scale(values)
    for row, (goal, obstacle) in enumerate(meaning.digits):
        value = values[0, obstacle, goal]
        if numpy.isfinite(value):
            stays = greedy[row] >= rotations
            axes.text(goal, obstacle, '•' if stays else '↑', rotation=0 if stays else 360 / rotations * greedy[row],
                      ha='center', va='center', color='black' if bright(value) > 0.6 else 'white', fontsize=11,
                      rotation_mode='anchor' if stays else 'default')
    axes.set_title(f'{axes.get_title()}\narrow: greedy action (up: ahead)')


def main(words=None):
    parser = parser_of('draw_q_table',
                       'Draws the values and visits of all rows of a Q-table as heat maps, or explains one '
                       'row.', EXAMPLES)
    parser.add_argument('table', metavar='FILE', help='a Q-table file, or a name in config/q_tables')
    add_file(parser, '--output', help='picture, such as table.png or table.pdf')
    parser.add_argument('--row', type=whole, metavar='N', help='print what row N means, with visits and values')
    parser.add_argument('--title', help='title of the picture (default: the name of the file)')
    add_tools(parser)
    arguments = parser.parse_args(words)
    if arguments.output is None and arguments.row is None:
        parser.error('expected --output or --row')
    if arguments.output and arguments.output.suffix.lower() not in PICTURES:
        parser.error(f"--output: expected a name with {', '.join(PICTURES)}, got '{arguments.output}'")
    if arguments.output:
        check_output(arguments.output)
    table = read_table(find_table(arguments.table))
    meaning = meaning_of(table, find_tools(arguments.tools) / 'train')
    if arguments.row is not None:
        if arguments.row >= table.header['rows']:
            raise InputError(f"--row: expected 0 to {table.header['rows'] - 1}, got {arguments.row}")
        print(f'row {arguments.row}: {meaning.describe(arguments.row)}')
        names = action_names(table)
        for name, visits, value in zip(names, table.visits[arguments.row], table.values[arguments.row]):
            print(f'  {name:{max(map(len, names))}}  {visits:>9} visits' + (f'  value {value:.6g}' if visits else ''))
    if arguments.output is not None:
        visits = row_visits(table)
        subtitle = f'{(visits > 0).sum()} of {len(visits)} rows visited, {visits.sum()} visits'
        draw_table(arguments.output, table, meaning, f'{arguments.title or pathlib.Path(arguments.table).name}: '
                   f'{meaning.type}, {subtitle}')
        print(f'{arguments.output}: {subtitle}')
