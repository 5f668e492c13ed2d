"""Formats results as printed lines, as JSON, and as rows of a document's table."""
import json
import os

from .catalogue import COSTS

KEYS = ('name', 'value', 'unit', 'yardstick', 'ratio')
HEADER = ['name', 'what', 'bar', 'measured', 'from, to', 'yardstick', 'measured', 'ratio', 'bar', 'bars are met']
LINE = '{:<30} {:>22}  {:>22}  {:>8}  {}'


def quantity(value, unit):
    """2510000, 'decisions/s' -> 2.51 M decisions/s"""
    if value is None:
        return ''
    if abs(value) >= 1e5:
        return f'{value / 1e6:.3g} M {unit}'
    return f'{value:,.0f} {unit}' if abs(value) >= 1000 else f'{value:.3g} {unit}'


def spread_text(spread):
    """(1390000, 2510000) -> 1.39 M, 2.51 M"""
    if spread is None or spread[0] == spread[1]:
        return ''
    return ', '.join(quantity(value, '').rstrip() for value in spread)


def ratio_text(result):
    return '' if result['ratio'] is None else f"{result['ratio']:.2f}"


def bar_text(number, at_most, text):
    """Returns a bar as a text; empty if there is none."""
    return '' if number is None else f"{'≤' if at_most else '≥'} {text(number)}"


def met_text(result, benchmark):
    """Returns whether the bars are met, as a text; empty without bars."""
    if benchmark is None or benchmark.bar is None and benchmark.ratio_bar is None:
        return ''
    return 'yes' if benchmark.clears_bar(result) else 'no'


def heading():
    return LINE.format('', 'measured', 'yardstick', 'ratio', 'bars met')


def line(result, benchmark=None):
    """Returns a result as a printed line."""
    return LINE.format(result['name'], quantity(result['value'], result['unit']),
                       quantity(result['yardstick'], result['unit']), ratio_text(result),
                       met_text(result, benchmark)).rstrip()


def row(result, benchmark):
    """Returns a result as cells of the document's table. A result through ROS is the best of its rounds, without a
    spread."""
    def in_unit(value):
        return quantity(value, benchmark.unit)
    return [benchmark.name, benchmark.title, bar_text(benchmark.bar, benchmark.unit in COSTS, in_unit),
            in_unit(result['value']), spread_text(result.get('spread')), benchmark.yardstick,
            in_unit(result['yardstick']), ratio_text(result),
            bar_text(benchmark.ratio_bar, not benchmark.ratio_is_rate, '{:g}'.format), met_text(result, benchmark)]


def write_json(file, results):
    """Writes the list of {name, value, unit, yardstick, ratio}; the file is replaced atomically."""
    beside = file.with_name(file.name + '.new')
    beside.write_text(json.dumps([{key: result[key] for key in KEYS} for result in results], indent=2) + '\n',
                      encoding='utf-8')
    os.replace(beside, file)
