"""Formats results as printed lines, as JSON, and as tables of documents, in which rows without new results are kept."""
import datetime
import json
import os
import pathlib
import re

from crowd_experiments.pages import Chapter, fill_document

from .catalogue import BENCHMARKS, COSTS

NAME = 'performance'  # tables are performance/benchmarks and so on
ROW = re.compile(r'^\| (\w+) \|(.*)\|$', re.MULTILINE)


def benchmark_rows(results, document):
    """Returns the rows of all benchmarks: from the results, otherwise from the document, otherwise empty."""
    measured = {result['name']: result for result in results}
    before = {name: [cell.strip() for cell in [name, *cells.split('|')]] for name, cells in ROW.findall(document)}
    return [row(measured[one.name], one) if one.name in measured else
            before.get(one.name, [one.name, one.title] + [''] * (len(HEADER) - 2)) for one in BENCHMARKS]


def machine_text(repetitions):
    """Returns rows that describe the machine and the measurement."""
    models = re.findall(r'^model name\s*: (.*)$', pathlib.Path('/proc/cpuinfo').read_text(encoding='utf-8'),
                        re.MULTILINE)
    model = models[0] if models else os.uname().machine
    load = os.getloadavg()[0]
    return [['measured', datetime.date.today().isoformat()], ['processor', f'{model}, {os.cpu_count()} threads'],
            ['repetitions', f'{repetitions}, of which the median, lowest and highest; of sweeps the fastest'],
            ['load when all was done', f'{load:.1f} (the benchmarks are 1 of it)']]


def fill(file, results, tables, repetitions):
    """Updates tables and pictures of the document. Returns a message for each one that was not measured.
    @param tables of sweeps and profiles: (entry, header, rows, picture or None)"""
    chapter = Chapter(NAME, 'Performance')
    if results:
        rows = benchmark_rows(results, file.read_text(encoding='utf-8'))
        chapter.add_table('Benchmarks', HEADER, rows, 'benchmarks')
        chapter.add_table('Measured on', ['', ''], machine_text(repetitions), 'machine')
    for entry, header, rows, picture in tables:
        chapter.add_table(entry.title, header, rows, entry.name)
        if picture:
            chapter.add_figure(picture, entry.title)
    return fill_document(file, [chapter])


KEYS = ('name', 'value', 'unit', 'yardstick', 'ratio')
HEADER = ['name', 'what', 'bar', 'measured', 'from, to', 'yardstick', 'measured', 'ratio', 'bar', 'bars are met']
LINE = '{:<30} {:>22}  {:>22}  {:>8}  {}'


HEADING = LINE.format('', 'measured', 'yardstick', 'ratio', 'bars met')


def quantity(value, unit, number=None):
    """2510000, 'decisions/s' -> 2.51 M decisions/s; an empty text for None. `number`: the format of the number."""
    if value is None or number:
        return '' if value is None else f'{value:{number}}'
    if abs(value) >= 1e5:
        return f'{value / 1e6:.3g} M {unit}'
    return f'{value:,.0f} {unit}' if abs(value) >= 1000 else f'{value:.3g} {unit}'


def spread_text(spread):
    """(1390000, 2510000) -> 1.39 M, 2.51 M"""
    if spread is None or spread[0] == spread[1]:
        return ''
    return ', '.join(quantity(value, '').rstrip() for value in spread)


def bar_text(number, at_most, text):
    """Returns a bar as a text; empty if there is none."""
    return '' if number is None else f"{'≤' if at_most else '≥'} {text(number)}"


def met_text(result, benchmark):
    """Returns whether the bars are met, as a text; empty without bars."""
    if benchmark is None or benchmark.bar is None and benchmark.ratio_bar is None:
        return ''
    return 'yes' if benchmark.clears_bar(result) else 'no'


def line(result, benchmark=None):
    """Returns a result as a printed line."""
    return LINE.format(result['name'], quantity(result['value'], result['unit']),
                       quantity(result['yardstick'], result['unit']), quantity(result['ratio'], '', '.2f'),
                       met_text(result, benchmark)).rstrip()


def row(result, benchmark):
    """Returns a result as cells of the document's table."""
    def in_unit(value):
        return quantity(value, benchmark.unit)
    return [benchmark.name, benchmark.title, bar_text(benchmark.bar, benchmark.unit in COSTS, in_unit),
            in_unit(result['value']), spread_text(result.get('spread')), benchmark.yardstick,
            in_unit(result['yardstick']), quantity(result['ratio'], '', '.2f'),
            bar_text(benchmark.ratio_bar, not benchmark.ratio_is_rate, '{:g}'.format), met_text(result, benchmark)]


def write_json(file, results):
    """Writes the list of {name, value, unit, yardstick, ratio}; the file is replaced atomically."""
    beside = file.with_name(file.name + '.new')
    beside.write_text(json.dumps([{key: result[key] for key in KEYS} for result in results], indent=2) + '\n',
                      encoding='utf-8')
    os.replace(beside, file)
