"""Logs of robots among people: lines of JSON, as `evaluate --robot-log` writes them (docs/metrics.md, Logs)."""
import json
import math
import typing

from crowd_drawing.errors import InputError, complete_lines, opened

EXPECTED = 'a line of a log of robots, as of `evaluate --robot-log`'


class RobotLog(typing.NamedTuple):
    """What is drawn of an episode of a log."""
    episode: int  # its number
    header: dict  # its first line
    walks: dict  # of people: lists of (tick, x, y) [m] by their ids
    robots: list  # for each one of the header a list of (tick, x, y, heading) [m, rad]
    radii: dict  # of people, by their ids [m]

    def document(self):
        """Returns a scenario with the walls, obstacles and robots of the episode."""
        return {'name': self.header.get('scenario', ''), 'tick': self.header['tick_duration'],
                'walls': [[wall[:2], wall[2:]] for wall in self.header.get('walls', [])],
                'obstacles': [{'position': [x, y], 'radius': radius}
                              for x, y, radius in self.header.get('obstacles', [])],
                'robots': [{'position': list(ways[0][1:3]), 'heading': {'radians': ways[0][3]},
                            **{key: robot[key] for key in ('radius', 'footprint') if key in robot}}
                           for robot, ways in zip(self.header['robots'], self.robots) if ways]}


def is_robot_log(file):
    """Returns whether a file is lines of JSON. Raises OSError."""
    with opened(file) as stream:
        return next((line for line in stream if line.strip()), '').lstrip().startswith('{')


def read_robot_log(file, episode=None):
    """Returns the RobotLog of an episode, which its header names; None: the first one. Raises InputError, OSError."""
    found, episodes = None, []
    with opened(file) as stream:
        for line, text in enumerate(complete_lines(stream, file), 1):
            if text.strip():
                try:
                    entry = json.loads(text)
                    if 'tick' not in entry:
                        if found:
                            break  # the next episode
                        episodes.append(int(entry.get('episode', len(episodes))))
                        if episode in (None, episodes[-1]):
                            found = begin(episodes[-1], entry)
                    elif found:
                        add_tick(found, entry)
                    elif not episodes:
                        raise ValueError
                except (KeyError, TypeError, ValueError, AttributeError):
                    raise InputError(f"{file}:{line}: expected {EXPECTED}, got '{text.strip()[:60]}'") from None
    if found is None:
        raise InputError(f'{file}: has no episode {episode}, expected {", ".join(map(str, episodes)) or "one"}')
    if not any(found.robots):
        raise InputError(f'{file}: the episode has no ticks')
    return found


def begin(episode, header):
    if not 0 < float(header['tick_duration']) < math.inf:
        raise ValueError
    return RobotLog(episode, header, {}, [[] for _ in header['robots']], {})


def add_tick(log, entry):
    tick, robots = int(entry['tick']), entry['robots']
    if len(robots) != len(log.robots):
        raise ValueError
    for way, robot in zip(log.robots, robots):
        way.append((tick, *finite(robot['x'], robot['y'], robot['heading'])))
    for person in entry.get('people', []):
        number = int(person['id'])
        log.walks.setdefault(number, []).append((tick, *finite(person['x'], person['y'])))
        if 'radius' in person:
            log.radii[number], = finite(person['radius'])


def finite(*values):
    """Returns numbers as float. Raises ValueError if one is not finite."""
    numbers = tuple(map(float, values))
    if not all(map(math.isfinite, numbers)):
        raise ValueError
    return numbers
