"""Choices that the thesis leaves open, and the alternatives to our choices that are tried."""
import dataclasses
import re

from crowd_experiments.variations import EVERY, read_documents, vary_config, vary_scenario

from .reward_runs import REWARDS

CONFIG, SCENARIO = 'training configuration', 'scenario'
SECTORS = 'state_set.obstacle_sectors'


@dataclasses.dataclass(frozen=True)
class Choice:
    """A choice that the thesis leaves open: a key of the training configuration or of the scenario."""
    name: str
    file: str  # CONFIG or SCENARIO
    key: str  # path of the key
    others: tuple  # alternative values
    default: str = ''  # if the file does not have the key

    def chosen(self, setting):
        """Returns the value in the thesis configuration, as a text."""
        file = setting.config_file(f'reward_{REWARDS[0]}_thesis') if self.file == CONFIG else \
            setting.scenario('single_obstacle')
        value = read_documents(file)[0]
        for key in self.key.split('.'):
            value = value[0] if key == EVERY else value.get(key, self.default)
        return value_text(value)


CHOICES = (
    Choice('epsilon in training', CONFIG, 'learning.epsilon', (0.01, 0.05, 0.2, 0.3)),
    Choice('ties', CONFIG, 'learning.ties', ('random',), 'first'),
    Choice('heading at the start', SCENARIO, 'agents.*.heading', ('goal', 'kept')),
    Choice('sector limits of set 1 [degrees]', CONFIG, SECTORS,
           ((30, 60, 90, 180), (22.5, 67.5, 112.5, 180))),
    Choice('radius of the obstacle [m]', SCENARIO, 'obstacles.*.radius', (0.2, 0.3, 0.5)),
    Choice('radius of the agent [m]', SCENARIO, 'agents.*.radius', (0.15, 0.4)),
    Choice('goal tolerance [m]', SCENARIO, 'goal_tolerance', (0.1, 0.5)),
    Choice('distance of the goal [m]', SCENARIO, 'agents.*.goal.ring.radius', (3.0, 4.0, 7.0)),
    Choice('order of moves', SCENARIO, 'order', ('simultaneous',)),
)


@dataclasses.dataclass(frozen=True)
class Variation:
    """The thesis configuration with one choice changed; without a choice the thesis configuration itself."""
    choice: Choice = None
    value: object = None

    def title(self):
        """Returns the label that is used in tables."""
        return f'{self.choice.name}: {self.value_text()}' if self.choice else 'thesis configuration'

    def value_text(self):
        """Returns the value as a text."""
        return value_text(self.value)

    def name(self):
        """Returns the name that is used for files."""
        return re.sub(r'[^a-z0-9.]+', '_', self.title().lower()).strip('_')

    def scenario(self, setting):
        """Returns the scenario for training and evaluation."""
        if self.choice and self.choice.file == SCENARIO:
            return vary_scenario(setting, 'single_obstacle', {self.choice.key: self.value},
                                 f'single_obstacle_{self.name()}')
        return setting.scenario('single_obstacle')

    def config(self, setting, reward):
        """Returns the training configuration."""
        base = f'reward_{reward}_thesis'
        if not self.choice:
            return setting.config_file(base)
        changes = {}
        if self.choice.file == CONFIG:
            changes = {self.choice.key: list(self.value) if isinstance(self.value, tuple) else self.value}
        return vary_config(setting, base, changes, f'{reward}_{self.name()}', [self.scenario(setting)])


def value_text(value):
    """15, 45, 90, 180"""
    return ', '.join(map(str, value)) if isinstance(value, (list, tuple)) else str(value)


THESIS = Variation()
VARIATIONS = (THESIS, *(Variation(choice, value) for choice in CHOICES for value in choice.others))
