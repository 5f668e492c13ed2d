"""Updates the tables of docs/performance.md and research/docs; rows without new results are kept."""
import datetime
import os
import pathlib
import re

from crowd_experiments.pages import Chapter, fill_document

from . import table
from .catalogue import BENCHMARKS

NAME = 'performance'  # tables are performance/benchmarks and so on
ROW = re.compile(r'^\| (\w+) \|(.*)\|$', re.MULTILINE)


def benchmark_rows(results, document):
    """Returns the rows of all benchmarks: from the results, otherwise from the document, otherwise empty."""
    measured = {result['name']: result for result in results}
    before = {name: [cell.strip() for cell in [name, *cells.split('|')]] for name, cells in ROW.findall(document)}
    rows = []
    for benchmark in BENCHMARKS:
        if benchmark.name in measured:
            rows.append(table.row(measured[benchmark.name], benchmark))
        else:
            rows.append(before.get(benchmark.name, [benchmark.name, benchmark.title] + [''] * (len(table.HEADER) - 2)))
    return rows


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
        chapter.add_table('Benchmarks', table.HEADER, rows, 'benchmarks')
        chapter.add_table('Measured on', ['', ''], machine_text(repetitions), 'machine')
    for entry, header, rows, picture in tables:
        chapter.add_table(entry.title, header, rows, entry.name)
        if picture:
            chapter.add_figure(picture, entry.title)
    return fill_document(file, [chapter])
