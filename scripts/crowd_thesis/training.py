"""The training of one agent: with one obstacle (thesis, 4.1), then among several (4.3)."""
import subprocess
import typing

import rospy
import yaml
from crowd_drawing.errors import read_documents
from crowd_experiments.tools import find_config
from crowd_launching.nodes import NodeError, ending_of, find_program, stop_nodes
from social_crowd import srv
from std_srvs.srv import SetBool

from .figures import write_record

LEARNED = 'learned.txt'  # the table of the agent


class Part(typing.NamedTuple):
    """A part of the training."""
    name: str
    config: str  # the training configuration is config/learning/thesis_STATES + this
    scenario: str
    share: int  # number of its episodes, as a multiple of those of the first part
    record: str  # file in the folder


PARTS = [Part('one obstacle', '', 'single_obstacle', 1, 'one_obstacle.csv'),
         Part('several obstacles', '_field', 'training_field', 2, 'several_obstacles.csv')]


def configuration_of(plan, part):
    """Returns the training configuration of a part."""
    config, = read_documents(find_config() / 'learning' / f'thesis_{plan.states}{part.config}.yaml')
    config['training'] = {'scenarios': [part.scenario], 'episodes': episodes_of(plan, part), 'seed': plan.seed}
    learning = config['learning']
    if plan.epsilon is not None:
        learning['epsilon'] = plan.epsilon
    elif isinstance(learning['epsilon'], dict):
        learning['epsilon']['episodes'] = episodes_of(plan, part)
    return config


def write_configuration(plan, part=None):
    """Writes the training configuration of a part, by default of the first one. Returns its file."""
    part = part or PARTS[0]
    file = plan.folder / f'{part.scenario}.yaml'
    file.write_text(yaml.safe_dump(configuration_of(plan, part), sort_keys=False), encoding='utf-8')
    return str(file)


def episodes_of(plan, part):
    return part.share * plan.training_episodes


def announce(plan, part):
    print(f'agent 0 trains alone: {episodes_of(plan, part)} episodes with {part.name} ({part.scenario})', flush=True)


def train(plan, nodes):
    """Trains with the program `train`, which shows its progress. The learner does not take part."""
    table = []
    for part in PARTS:
        announce(plan, part)
        run(nodes, 'train', write_configuration(plan, part), *table, '--output', plan.file(LEARNED), '--record',
            plan.file(part.record))
        table = ['--q-table', plan.file(LEARNED)]


def run(nodes, program, *words):
    """Runs a program of the package. Raises NodeError if it fails."""
    process = subprocess.Popen([find_program(program), *words], stdin=subprocess.DEVNULL, start_new_session=True)
    try:
        nodes.wait(lambda: process.poll() is not None)
    finally:
        if process.poll() is None:
            stop_nodes([process])
    if process.returncode != 0:
        raise NodeError(f'{program} {ending_of(process.returncode)}')


def train_watched(plan, nodes, controller):
    """Trains through ROS, where it can be watched: the learner learns what train() would have learned. `controller`:
    parameters of the controller."""
    for part in PARTS:
        announce(plan, part)
        # Before the controller begins: each part has a schedule of its own, from the controller's episode 0.
        nodes.call('learner/set_learning_parameters', srv.SetLearningParameters,
                   parameters=yaml.safe_dump(configuration_of(plan, part)['learning']))
        nodes.start_controller(**{**controller, 'real_time_factor': plan.training_factor},
                               config=write_configuration(plan, part), seed=plan.seed,
                               episodes=episodes_of(plan, part))
        nodes.call('crowd_controller/pause', SetBool, data=False)
        nodes.wait_for_results(episodes_of(plan, part))
        write_record(plan.file(part.record), nodes.results)
    answer = nodes.call('learner/save_q_table', srv.SaveQTable, file=LEARNED, agent=0, overwrite=True)
    rospy.loginfo('%s', answer.message)
