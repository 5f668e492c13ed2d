"""Simulated people in place of recorded ones: scenarios for `evaluate`, and what it makes of them."""
import numpy
from crowd_drawing.files import DEFAULT_TICK, read_walks
from crowd_experiments.records import read_tracks
from crowd_experiments.runs import ProgressBar, output_of

from .people import PREDICTED, STEP, resampled

FREE_SPEED = 75  # [%] percentile of the speeds of a walker that is its free speed
PATIENCE = 60.0  # [s] after the last recorded person has left
TOLERANCE = 0.05  # [m] of goals of predictions
BATCH = 50  # documents in a file
SLOWEST = 0.01  # [m/s] of an agent, which must have a speed
WALKING = 0.99  # of its speed, at most, is its velocity at the start, however both are rounded


def walk_all(walkers, evaluate, table, radius, folder):
    """Walks agents with entry, exit, time and free speed of walkers. Returns them as Walkers. Raises RunError."""
    start, end = min(walker.times[0] for walker in walkers), max(walker.times[-1] for walker in walkers)
    lines = ['name: replaced', f'duration: {end - start + PATIENCE:g}', 'goal_tolerance: 0.3', 'sources:']
    for walker in walkers:
        speed = numpy.percentile(walker.speeds(), FREE_SPEED)
        lines.append(f'  - {{area: {point(walker.places[0])}, times: [{walker.times[0] - start:.2f}], '
                     f'goal: {point(walker.places[-1])}, speed: {speed:.3f}, radius: {radius:g}}}')
    file = folder / 'replaced.yaml'
    file.write_text('\n'.join(lines) + '\n', encoding='utf-8')
    output_of([evaluate, '--q-table', table, '--trajectories', folder, file])
    walks = [numpy.array(walk) for walk in read_walks(file.with_suffix('.csv'), 0)[1].values()]
    tracks = [resampled(walk[:, 0] * DEFAULT_TICK, walk[:, 1:]) for walk in walks]
    return [track for track in tracks if len(track.times) > 4]


def point(place):
    return f'[{place[0]:.4f}, {place[1]:.4f}]'


class Crowd:
    """Predicts with the agents of a Q-table."""

    def __init__(self, evaluate, table, radius, folder):
        self.evaluate, self.table, self.radius, self.folder = evaluate, table, radius, folder

    def predict(self, tasks):
        """Returns the places after each step, an array (person, PREDICTED, 2) for each Task. Raises RunError."""
        bar, found = ProgressBar(len(tasks), len(tasks), 'moments'), []
        try:
            for first in range(0, len(tasks), BATCH):
                batch = tasks[first:first + BATCH]
                found += self.walk(batch)
                for _ in batch:
                    bar.add(1)
        finally:
            bar.end()
        return found

    def walk(self, tasks):
        """Predicts a batch of tasks: one document each."""
        file = self.folder / 'moments.yaml'
        file.write_text('---\n'.join(map(self.document, tasks)), encoding='utf-8')
        output_of([self.evaluate, '--q-table', self.table, '--trajectories', self.folder, file])
        tracks, ticks = read_tracks(file.with_suffix('.csv')), round(STEP / DEFAULT_TICK)
        return [sample(tracks[number], task, ticks) for number, task in enumerate(tasks)]

    def document(self, task):
        lines = ['name: moment', f'duration: {PREDICTED * STEP:g}', f'goal_tolerance: {TOLERANCE:g}', 'agents:']
        for place, velocity, goal, radius in zip(*task, task.radii(self.radius)):
            speed = numpy.hypot(*velocity)
            if numpy.hypot(*(goal - place)) < 2 * TOLERANCE:
                goal, speed = place + [1.0, 0.0], 0.0  # is there and stays
            start = WALKING * velocity if speed > SLOWEST else numpy.zeros(2)
            lines.append(f'  - {{position: {point(place)}, goal: {point(goal)}, speed: {max(speed, SLOWEST):.4f}, '
                         f'velocity: {point(start)}, radius: {radius:.4f}}}')
        return '\n'.join(lines) + '\n'


def sample(track, task, ticks):
    """Returns the places of people after each step; those who have arrived stay where they were."""
    found = numpy.empty((len(task.places), PREDICTED, 2))
    for person in range(len(task.places)):
        walk = track[:, person]
        walk = walk[numpy.isfinite(walk[:, 0])]
        found[person] = walk[numpy.minimum(ticks * numpy.arange(1, PREDICTED + 1), len(walk) - 1)]
    return found
