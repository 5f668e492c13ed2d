"""A case of the validation, and its result."""
import dataclasses
import json
import pathlib
import typing

RESULT_FILE = 'result.json'  # in a case's folder


@dataclasses.dataclass(frozen=True)
class Result:
    """The result of a case. Texts are for tables."""
    measured: str  # with the spread over the seeds
    expected: str
    passed: typing.Optional[bool]  # None: the case only documents a behaviour
    remarks: str = ''  # for example where people are stuck
    pictures: tuple = ()  # files, in the case's folder

    def verdict(self):
        """Returns the text of the column `passed`."""
        return {True: 'yes', False: 'no', None: 'reported'}[self.passed]


@dataclasses.dataclass(frozen=True)
class Case:
    """A test. `run(evaluation)` runs the tool with all seeds, draws pictures, returns a Result; see evaluation.py."""
    name: str  # on the command line
    title: str
    run: typing.Callable


def store(folder, result, seeds):
    """Writes a result to a case's folder."""
    record = dataclasses.asdict(result)
    record['pictures'] = [pathlib.Path(picture).name for picture in result.pictures]
    record['seeds'] = seeds
    (folder / RESULT_FILE).write_text(json.dumps(record, indent=2) + '\n', encoding='utf-8')


def load(folder):
    """Returns the stored result of a case and its number of seeds; None if the case has not been run."""
    try:
        record = json.loads((folder / RESULT_FILE).read_text(encoding='utf-8'))
        seeds = record.pop('seeds')
        pictures = tuple(folder / name for name in record.pop('pictures'))
        return Result(**record, pictures=pictures), seeds
    except (OSError, ValueError, KeyError, TypeError):
        return None
