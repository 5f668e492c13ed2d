"""Parsing and writing Q-table files, and training configurations."""
import yaml
from programs import read_text


class QTableFile:
    """A parsed Q-table file: header as a map, rows as {row: [(visits, value) by action]}, visits of other sources as
    {source: {row: [visits by action]}}."""

    def __init__(self, file):
        text = read_text(file)
        head, _, body = text.partition('\n---\n')
        self.magic, _, header = head.partition('\n')
        self.header = yaml.safe_load(header)
        *lines, self.checksum = body.splitlines()
        self.rows = {}
        self.others = {}
        for line in lines[self.header['visited_rows']:]:
            first, *words = line.split(' ')
            if first == 'source':
                visits = self.others.setdefault(words[0], {})
            else:
                visits[int(first)] = [int(word) for word in words]
        for line in lines[:self.header['visited_rows']]:
            row, *words = line.split(' ')
            self.rows[int(row)] = [(int(words[i]), float(words[i + 1])) for i in range(0, len(words), 2)]

    def visits(self):
        """Returns the sum of all visits."""
        return sum(visits for actions in self.rows.values() for visits, _ in actions)


NEAREST_MODEL = """\
state_set: {type: nearest_obstacle, goal_sectors: 8, obstacle_sectors: [15, 45, 90, 180], collision_radius: 0.5, \
vision_radius: 1}
action_set: {type: kings_moves, rotations: 8}
reward: {goal: cosine_cubed, arrival: 100, obstacle_cost: 80}
rows: 137
actions: 8
"""


def q_table_text(rows, decisions=0):
    """Returns a Q-table file for the thesis's first state set; rows are {row: {action: (visits, value)}}."""
    text = f'social_crowd Q-table 1\n{NEAREST_MODEL}alpha: 0.1\ngamma: 0.1\nlambda: 0\nepsilon: 0.1\n'
    text += f'decisions: {decisions}\nseed: 1\nvisited_rows: {len(rows)}\n---\n'
    for row, actions in sorted(rows.items()):
        cells = [actions.get(action, (0, 0.0)) for action in range(8)]
        text += str(row) + ''.join(f' {visits} {value:.17g}' for visits, value in cells) + '\n'
    return f'{text}checksum: {checksum_of(text)}\n'


def checksum_of(text):
    """Returns the 64-bit FNV-1a hash of a text."""
    value = 0xCBF29CE484222325
    for byte in text.encode():
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return f'{value:016x}'


def config_text(scenario, episodes, seed=1, tables='shared', learning='{alpha: 0.2, gamma: 0.9, epsilon: 0.3}',
                model=NEAREST_MODEL):
    """Returns a training configuration."""
    parts = ''.join(line + '\n' for line in model.splitlines() if not line.startswith(('rows', 'actions')))
    return (f'{parts}learning: {learning}\n'
            f'training: {{scenarios: [{scenario}], episodes: {episodes}, seed: {seed}, tables: {tables}}}\n')
