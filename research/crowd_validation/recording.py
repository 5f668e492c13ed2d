"""A recorded episode."""
import dataclasses

import numpy
import yaml

from crowd_experiments.records import read_csv

LOADER = getattr(yaml, 'CSafeLoader', yaml.SafeLoader)


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
        """Returns the number of agents."""
        return len(self.arrivals)

    def all_arrived(self):
        """Returns whether every agent arrived."""
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
    """Reads the output of evaluate for one episode of the scenario file NAME.yaml: trajectories/, scenes/, record.csv.
    Replaces the trajectories by a file of a tenth of their size."""
    with open(folder / 'scenes' / f'{name}.yaml', encoding='utf-8') as stream:
        scene = next(document for document in yaml.load_all(stream, LOADER) if document)
    record = read_csv(folder / 'record.csv')
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
    rows = numpy.loadtxt(file, delimiter=',', skiprows=1, ndmin=2, usecols=(1, 2, 3, 4))
    ticks = rows[:, 0].astype(int)
    tracks = numpy.full((ticks.max() + 1, agents, 2), numpy.nan)
    tracks[ticks, rows[:, 1].astype(int)] = rows[:, 2:]
    numpy.save(compact, tracks.astype(numpy.float32))
    file.unlink()
    return tracks
