"""The benchmarks with their units and required values (bars); their results as printed lines, as JSON, and as tables of
documents, in which rows without new results are kept."""
import datetime
import os
import pathlib
import re
import typing

import yaml
from crowd_experiments.pages import Chapter, fill_document

DECISIONS, AGENT_STEPS, TICKS, REAL_TIME, MILLISECONDS, MEGABYTES, SHARE_OF_CORE = (
    'decisions/s', 'agent steps/s', 'ticks/s', 'x real time', 'ms', 'MB', '% of a core')
# Units of which lower values are better; all other units are rates.
COSTS = (MILLISECONDS, MEGABYTES, SHARE_OF_CORE)
HEADER = ['name', 'what', 'bar', 'measured', 'from, to', 'yardstick', 'measured', 'ratio', 'bar', 'bars are met']
LINE = '{:<30} {:>22}  {:>22}  {:>8}  {}'
HEADING = LINE.format('', 'measured', 'yardstick', 'ratio', 'bars met')


class Benchmark(typing.NamedTuple):
    """One line of the table.

    The ratio is the benchmark's time divided by the yardstick's time (rates: yardstick / value, times: value /
    yardstick). With `ratio_is_rate` it is the benchmark's rate divided by the yardstick's rate (value / yardstick)."""
    name: str
    title: str
    unit: str
    bar: float = None
    yardstick: str = ''  # in words; empty: none
    ratio_bar: float = None
    ratio_is_rate: bool = False
    ros: bool = False  # measured through ROS
    mpi: bool = False  # measured under mpirun
    repetitions: int = None  # None: as requested on the command line

    def ratio(self, value, yardstick):
        return value / yardstick if self.ratio_is_rate or self.unit in COSTS else yardstick / value

    def result(self, value, yardstick=None, ratio=None, spread=None):
        """Returns the result as a dictionary.
        @param spread lowest and highest of the repetitions, of which the value is the median"""
        return {'name': self.name, 'value': value, 'unit': self.unit, 'spread': spread, 'yardstick': yardstick,
                'ratio': ratio}

    def clears_bar(self, result):
        value, ratio = result['value'], result['ratio']
        fine = self.bar is None or (value <= self.bar if self.unit in COSTS else value >= self.bar)
        if self.ratio_bar is None:
            return fine
        return fine and ratio is not None and (
            ratio >= self.ratio_bar if self.ratio_is_rate else ratio <= self.ratio_bar)


BENCHMARKS = tuple(Benchmark(**entry) for entry in yaml.safe_load(
    pathlib.Path(__file__).with_name('benchmarks.yaml').read_text(encoding='utf-8')))
ROW = re.compile(r'^\| (\w+) \|(.*)\|$', re.MULTILINE)


def machine_text(repetitions):
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
    chapter = Chapter('performance', 'Performance')  # tables are performance/benchmarks and so on
    if results:
        before = {name: [cell.strip() for cell in [name, *cells.split('|')]]
                  for name, cells in ROW.findall(file.read_text(encoding='utf-8'))}  # remain without new results
        measured = {result['name']: result for result in results}
        chapter.add_table('Benchmarks', HEADER, [
            row(measured[one.name], one) if one.name in measured else
            before.get(one.name, [one.name, one.title] + [''] * (len(HEADER) - 2)) for one in BENCHMARKS], 'benchmarks')
        chapter.add_table('Measured on', ['', ''], machine_text(repetitions), 'machine')
    for entry, header, rows, picture in tables:
        chapter.add_table(entry.title, header, rows, entry.name)
        chapter.add_figure(picture, entry.title)
    return fill_document(file, [chapter])


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
    return '' if number is None else f"{'≤' if at_most else '≥'} {text(number)}"


def met_text(result, benchmark):
    """Returns whether the bars are met, as a text; empty without bars."""
    if benchmark.bar is None and benchmark.ratio_bar is None:
        return ''
    return 'yes' if benchmark.clears_bar(result) else 'no'


def line(result, benchmark):
    return LINE.format(result['name'], quantity(result['value'], result['unit']),
                       quantity(result['yardstick'], result['unit']), quantity(result['ratio'], '', '.2f'),
                       met_text(result, benchmark)).rstrip()


def row(result, benchmark):
    def in_unit(value):
        return quantity(value, benchmark.unit)
    return [benchmark.name, benchmark.title, bar_text(benchmark.bar, benchmark.unit in COSTS, in_unit),
            in_unit(result['value']), spread_text(result.get('spread')), benchmark.yardstick,
            in_unit(result['yardstick']), quantity(result['ratio'], '', '.2f'),
            bar_text(benchmark.ratio_bar, not benchmark.ratio_is_rate, '{:g}'.format), met_text(result, benchmark)]
