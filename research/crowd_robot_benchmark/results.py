"""The results file: a row for each episode of a robot, with what determines it and the columns of
`evaluate --robots-csv` exactly as they were written."""
import csv
import hashlib
import typing

from crowd_drawing.errors import complete_lines, opened, replaced
from crowd_experiments.runs import RunError

from .identity import Identity
from .suite import RECORD, ROBOTS, SEED

NAMED = len(Identity._fields)
EPISODE, SCENARIO = 'episode', 'scenario'  # the first columns of a record


class Row(typing.NamedTuple):
    """A row of a results file."""
    line: int
    identity: Identity
    values: list  # texts, by the columns of the record but the first two

    def place(self):
        return f'{self.identity.baseline} in {self.identity.scenario}, episode {self.identity.episode}'


def read_texts(file):
    """Returns the header and the rows of a CSV file, as texts. Raises RunError."""
    with opened(file, newline='') as stream:
        reader = csv.reader(complete_lines(stream, file))
        header = next(reader, [])
        rows = list(reader)
    for number, row in enumerate(rows, 2):
        if len(row) != len(header):
            raise RunError(f'{file}:{number}: expected {len(header)} values, got {len(row)}')
    return header, rows


def record_rows(file):
    """Returns the columns of a record but the first two, and its rows by episode. Raises RunError."""
    header, rows = read_texts(file)
    if header[:2] != [EPISODE, SCENARIO]:
        raise RunError(f'{file}:1: expected a record as of `evaluate --robots-csv`')
    return header[2:], {row[0]: row[2:] for row in rows}


def write_results(file, suite, inputs, robots):
    """Writes the results of the finished runs of robots in all scenes, and in CrowdNav's setting; episodes that are in
    both once. Returns the number of rows, and the digest of the file."""
    columns, lines = None, {}
    for robot in robots:
        for keys, scene, run in suite.all_runs(robot):
            if not run.is_done():
                continue
            columns, rows = record_rows(run.folder / RECORD)
            baseline = ROBOTS[robot]._replace(keys={**ROBOTS[robot].keys, **keys})
            for episode, values in rows.items():
                identity = inputs.identity(robot, baseline, scene, SEED, episode)
                lines.setdefault((robot, identity.hash), [*identity, *values])
    if columns is None:
        raise RunError(f'{suite.output}: has no results')
    with replaced(file) as part, open(part, 'w', newline='', encoding='utf-8') as stream:
        writer = csv.writer(stream, lineterminator='\n')
        writer.writerow([*Identity._fields, *columns])
        writer.writerows(lines.values())
    return len(lines), file_digest(file)


def file_digest(file):
    """Returns the SHA-256 of a file."""
    return hashlib.sha256(file.read_bytes()).hexdigest()


def read_results(file):
    """Returns the columns of the record in a results file, and its Rows. Raises RunError, OSError."""
    header, lines = read_texts(file)
    if tuple(header[:NAMED]) != Identity._fields or len(header) == NAMED:
        raise RunError(f'{file}:1: expected results of robot_benchmark, with the columns '
                       f'{",".join(Identity._fields)},...')
    rows = [Row(number, Identity(*line[:NAMED]), line[NAMED:]) for number, line in enumerate(lines, 2)]
    if not rows:
        raise RunError(f'{file}: has no rows')
    return header[NAMED:], rows
