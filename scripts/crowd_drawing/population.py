"""Sources, sinks, queues and gates of a scenario, as far as they can be drawn."""
import math


class Population:
    """Areas of sources and sinks: their places; queues: line from the head; gates: wall, and when it is open."""

    def __init__(self, scene, document):
        self.scene = scene
        sources = scene.listed(document, 'sources')
        for i, source in enumerate(sources):
            scene.need(isinstance(source, dict) and 'area' in source and 'radius' in source, f'sources[{i}]',
                       'a map with area and radius', source)
        self.source_areas = [source['area'] for source in sources]
        self.source_radii = [scene.radius(source, f'sources[{i}]') for i, source in enumerate(sources)]
        self.sink_areas = [sink['area'] for sink in self.named(document, 'sinks', 'area')]
        self.queues = [self.queue(queue) for queue in self.named(document, 'queues', 'head', 'direction')]
        self.gates = [(scene.wall(gate['wall'], 'gates'), gate.get('open', False))
                      for gate in self.named(document, 'gates', 'wall')]

    def named(self, document, key, *needed):
        """Returns the values of a map of maps that have the needed keys."""
        entries = document.get(key) or {}
        self.scene.need(isinstance(entries, dict), key, 'a map of names', entries)
        for name, entry in entries.items():
            has_all = isinstance(entry, dict) and all(word in entry for word in needed)
            self.scene.need(has_all, f'{key}.{name}', f"a map with {', '.join(needed)}", entry)
        return list(entries.values())

    def queue(self, entry):
        """Returns the head of a queue and the place of the fifth in line."""
        x, y = self.scene.point(entry['head'], 'queues')
        angle = math.radians(self.scene.number(entry['direction'], 'queues'))
        length = 4 * self.scene.number(entry.get('spacing', 0.6), 'queues')
        return (x, y), (x + length * math.cos(angle), y + length * math.sin(angle))


def is_open(periods, time):
    """Returns whether a gate is open at a time [s], given its key `open`: true, false, or a list of periods."""
    if isinstance(periods, bool):
        return periods
    return any(begin <= time < end for begin, end in periods)
