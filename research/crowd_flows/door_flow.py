"""Flow of people through a door, beside experiments.

60 people stand in front of a door in a wall, at 2.5 per m2, and walk through it. The flow is 59 / (time between the
crossings of the line of the wall by the first and by the last person).
"""
import numpy
from crowd_experiments import style

from .measurements import COLOURS, TICK, door_range, read_columns, walk

COUNT = 60
WIDTHS = (0.8, 0.9, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.2, 2.4)  # [m]
FIGURE = 'validation_door_flow.png'
HEADER = ['width', 'flow', 'flow_low', 'flow_high', 'through', 'range_low', 'range_high', 'inside']
SCENARIO = '''name: door
duration: 150
goal_tolerance: 0.3
agents:
  - {{count: {count}, position: {{box: [[-4.3, -3], [-0.3, 3]]}}, goal: {{box: [[4, -3], [8, 3]]}}, speed: [1.1, 1.6],
     radius: 0.2}}
walls:
  - [[0, -10], [0, -{half:g}]]
  - [[0, {half:g}], [0, 10]]
'''


def flow_of(track):
    """Returns the flow [1/s] and the number of people who passed the door."""
    crossed = track[..., 0] >= 0.0
    through = crossed.any(axis=0)
    times = TICK * numpy.sort(crossed.argmax(axis=0)[through])
    if len(times) < 2:
        return 0.0, len(times)
    return (len(times) - 1) / (times[-1] - times[0]), len(times)


def measure_crowd(program, table, folder, seeds, data, widths=WIDTHS):
    """Returns rows of HEADER, one for each width."""
    folder.mkdir(parents=True, exist_ok=True)
    measured = read_columns(data / 'door_flow.csv', 'width_m', 'flow_per_s')
    rows = []
    for width in widths:
        _, tracks = walk(program, table, folder / f'door_{width:g}.yaml',
                         SCENARIO.format(count=COUNT, half=width / 2.0), '--episodes', seeds)
        flows, through = numpy.transpose([flow_of(track) for track in tracks])
        known = door_range(measured, width)
        mean = float(flows.mean())
        cells = ['', '', ''] if known is None else [
            round(known[0], 2), round(known[1], 2), 'yes' if known[0] <= mean <= known[1] else 'no']
        rows.append([width, round(mean, 2), round(flows.min(), 2), round(flows.max(), 2), int(through.min()), *cells])
    return rows


def plot(doors, data, file):
    """Draws the flows of several crowds (rows by name) beside the experiments. Returns the file."""
    figure, axes = style.new_figure(1, 1, 7, 4.5)
    panel = axes[0][0]
    measured = read_columns(data / 'door_flow.csv', 'width_m', 'flow_per_s')
    panel.plot(*measured[measured[:, 0] <= max(WIDTHS) + 0.4].T, '.', color='0.55', label='experiments')
    for (name, rows), colour in zip(doors.items(), COLOURS):
        width, flow, low, high = numpy.array([row[:4] for row in rows], dtype=float).T
        panel.errorbar(width, flow, (flow - low, high - flow), fmt='o-', capsize=3, color=colour, label=name)
    panel.set(xlabel='width of the door [m]', ylabel='people per second')
    panel.set_ylim(bottom=0.0)
    panel.legend(loc='upper left')
    return style.save(figure, file)
