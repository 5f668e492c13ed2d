"""A robot among people as an environment of Gymnasium, without ROS."""
from social_crowd.checks import whole_number
from social_crowd.local_robots import LocalRobots
from social_crowd.rewards import progress_reward
from social_crowd.robot_env import RobotEnv, no_more, tick_of

EPISODE_OPTIONS = ('episode', 'number')


def start_of(element, scenario, seed, options):
    """Returns element, scenario, seed, instance and number of an episode, as LocalRobots.begin() takes them.

    options: `episode`: which episode of the seed is drawn, as in `evaluate`; else the first one. `number`: of the
    episode, on which the gait of people depends; else `episode`. Through ROS it counts up
    """
    episode = whole_number('episode', options.get('episode', 0))
    return element, scenario, seed, episode, whole_number('number', options.get('number', episode))


class Env(RobotEnv):
    """Drives one robot of a scenario, in this process. The interface is that of gymnasium.Env (docs/python.md).

    The same scenario, seed, table and actions give the same observations, bit for bit, on every machine, and through
    ROS (crowd_env.CrowdEnv).
    """

    def __init__(self, scenario, table='anticipation', *, robot='', ticks=1, observation='scan', action='twist',
                 reward=progress_reward, contact_ends=True, render_mode=None):
        """Reads the scenario.

        scenario: see inputs.as_scenario(); of a list of scenarios, one is drawn for each episode
        table: the Q-table of the people: a QTable, the name of one of the package, or a file
        robot: its name; empty: the first one. Other robots stand
        ticks: that one action holds
        observation: scan, people, grid, or an Observation
        action: twist (ahead [m/s], rotation [rad/s]; of a holonomic robot ahead, left, rotation) or velocity (ahead,
            left; of a holonomic robot)
        reward: a function of what is known of the robot before and after a step, see rewards.py
        contact_ends: whether a contact with people ends an episode
        render_mode: None, or 'rgb_array' for render()
        """
        backend = LocalRobots(scenario, table, 1, is_batch=False, robot=robot, ticks=ticks, observation=observation,
                              threads=1)
        super().__init__(backend, observation=observation, action=action, reward=reward, contact_ends=contact_ends,
                         render_mode=render_mode)
        self._start = None

    def _begin(self, scenario, seed, options):
        no_more(options, EPISODE_OPTIONS)
        start = start_of(0, scenario, seed, options)
        self._task.backend.begin([start])
        self._start = start

    def _info(self):
        return {'episode_number': self._start[4], 'tick': tick_of(self._task), 'seed': self._start[2]}
