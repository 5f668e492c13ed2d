"""A case of the validation: runs of evaluate with its scenarios, recorded episodes, and its result."""
import dataclasses
import json
import pathlib
import typing

import numpy
import yaml
from crowd_experiments import records
from crowd_experiments.runs import Run, Runner
from crowd_experiments.variations import DUMPER, read_documents

from .plan import TICK

RESULT_FILE = 'result.json'  # in a case's folder


@dataclasses.dataclass(frozen=True, eq=False)
class Recording:
    """The trajectories of an episode. Absent agents are nan."""
    tracks: numpy.ndarray  # (tick, agent, 2) [m]
    tick: float  # [s]
    walls: list  # of [[x1, y1], [x2, y2]] [m]
    radii: numpy.ndarray  # [m]
    speeds: numpy.ndarray  # maximum speeds [m/s]
    arrivals: numpy.ndarray  # [s], inf for agents that did not arrive
    touched: numpy.ndarray  # whether the agent was in contact with a body or a wall

    def people(self):
        return len(self.arrivals)

    def all_arrived(self):
        return bool(numpy.isfinite(self.arrivals).all())

    def place_at(self, time):
        """Returns the places of all agents at a time [m], nan for agents that have left."""
        return self.tracks[min(round(time / self.tick), len(self.tracks) - 1)]

    def last_places(self):
        """Returns the last recorded place of each agent [m]."""
        present = ~numpy.isnan(self.tracks[:, :, 0])
        last = len(present) - 1 - numpy.argmax(present[::-1], axis=0)
        return self.tracks[last, numpy.arange(self.people())]


def read_recording(folder, name, tick):
    """Reads the output of evaluate for one episode of NAME.yaml, and makes the trajectories a smaller file."""
    scene = read_documents(folder / 'scenes' / f'{name}.yaml')[0]
    record = records.read_csv(folder / 'record.csv')
    arrivals = numpy.where(record['arrived'] > 0, record['ticks'] * tick, numpy.inf)
    agents = scene['agents']
    return Recording(read_tracks(folder / 'trajectories' / f'{name}.csv', len(agents)), tick, scene.get('walls') or [],
                     numpy.array([agent['radius'] for agent in agents], dtype=float),
                     numpy.array([agent['speed'] for agent in agents], dtype=float), arrivals, record['touched'] > 0)


def read_tracks(file, agents):
    """Returns the tracks of a file of evaluate, or of the smaller file that replaced it."""
    compact = file.with_suffix('.npy')
    if compact.is_file() and not file.is_file():
        return numpy.load(compact).astype(float)
    tracks, = records.read_tracks(file, agents).values()
    numpy.save(compact, tracks.astype(numpy.float32))
    file.unlink()
    return tracks


@dataclasses.dataclass(frozen=True)
class Result:
    """The result of a case. Texts are for tables."""
    measured: str  # with the spread over the seeds
    expected: str
    passed: typing.Optional[bool]  # None: the case only documents a behaviour
    remarks: str = ''  # for example where people are stuck
    pictures: tuple = ()  # files, in the case's folder

    def verdict(self):
        return {True: 'yes', False: 'no', None: 'reported'}[self.passed]


class Case(typing.NamedTuple):
    """A test. `run(evaluation)` runs the tool with all seeds, draws pictures, returns a Result."""
    name: str  # on the command line
    title: str
    run: typing.Callable


def store(folder, result, seeds):
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


class Evaluation(typing.NamedTuple):
    """The tool, the Q-table, and folder and seeds of a case. Results of earlier runs of the same are used again."""
    evaluate: pathlib.Path
    q_table: pathlib.Path
    folder: pathlib.Path
    seeds: int
    processes: int = 1

    def walk(self, plans):
        """Runs one episode of every plan with every seed. `plans` are functions of the seed that return a scenario
        document, by the names of the scenarios. Returns lists of Recordings, one for each seed, by these names.

        Raises RunError with the tool's message if it fails."""
        seeds = range(1, self.seeds + 1)
        runs = {(name, seed): self.run_of(name, plan(seed), seed) for name, plan in plans.items() for seed in seeds}
        left = [run for run in runs.values() if not run.is_done()]
        if left:
            Runner(self.processes).carry_out(left)
        return {name: [read_recording(runs[name, seed].folder, name, TICK) for seed in seeds] for name in plans}

    def walk_one(self, name, plan):
        """Runs one episode of a plan with every seed. Returns Recordings, one for each seed."""
        return self.walk({name: plan})[name]

    def run_of(self, name, document, seed):
        file = self.folder / 'scenarios' / f'seed_{seed}' / f'{name}.yaml'
        file.parent.mkdir(parents=True, exist_ok=True)
        text = yaml.dump(document, None, DUMPER, sort_keys=False, default_flow_style=None, width=120)
        file.write_text(text, encoding='utf-8')
        command = [self.evaluate, '--q-table', self.q_table, '--seed', seed, '--threads', 1, '--trajectories',
                   'trajectories', '--scenes', 'scenes', '--record', 'record.csv', file]
        walked = sum(entry.get('count', 1) for entry in document.get('agents', [])) * document['duration']
        return Run(self.folder / 'runs' / f'{name}_{seed}', [command], max(1.0, walked / 20000.0))
