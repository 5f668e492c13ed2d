"""Shows the method of the thesis, see scripts/show_thesis."""
import pathlib

import rospy
from crowd_drawing.errors import InputError, problem_of
from crowd_launching.nodes import NodeError
from crowd_launching.program import end_launch
from social_crowd import srv
from std_srvs.srv import SetBool

from .crowd_nodes import LEARNER, CrowdNodes, Stopped
from .figures import SCENE, TRAJECTORIES, draw, table_of, write_record
from .plan import WATCHED, read_plan
from .training import LEARNED, PARTS, train, train_watched, write_configuration

CROWD = 'crowd.csv'  # record of the crowd


class Show:
    """One agent trains, its table is shared, and the crowd walks."""

    def __init__(self, plan):
        self.plan = plan
        self.nodes = CrowdNodes()
        self.controller = {'data_folder': str(plan.folder), 'answer_deadline': plan.answer_deadline}
        self.has_begun = False  # the crowd, whose figures are not printed yet

    def run(self):
        plan = self.plan
        plan.folder.mkdir(parents=True, exist_ok=True)
        self.start_learner()
        if plan.training == WATCHED:
            train_watched(plan, self.nodes, self.controller)
            self.start_crowd(plan.episodes, trajectories=plan.file(TRAJECTORIES))
        else:
            self.start_crowd(plan.episodes, trajectories=plan.file(TRAJECTORIES))  # it stands meanwhile
            train(plan, self.nodes)
        self.share()
        self.let_walk()
        self.nodes.wait_for_results(plan.episodes)
        if plan.ends:
            self.nodes.stop()  # the learner saves the tables
        self.print_figures()
        files = draw(plan, [(part.name, plan.file(part.record)) for part in PARTS], self.name())
        print(f'pictures: {", ".join(files)}', flush=True)
        if plan.ends:
            return
        print('the crowd walks on until Ctrl-C', flush=True)
        self.start_crowd(0)
        self.nodes.call('crowd_controller/pause', SetBool, data=False)
        self.nodes.wait(lambda: False)

    def name(self):
        return pathlib.Path(self.plan.scenario).stem

    def start_learner(self):
        self.nodes.start(LEARNER, mode='training', tables='own', config=write_configuration(self.plan),
                         seed=self.plan.seed, save_to=self.plan.file('crowd.txt'), data_folder=str(self.plan.folder))

    def start_crowd(self, episodes, **parameters):
        self.nodes.start_controller(**self.controller, real_time_factor=self.plan.real_time_factor, seed=self.plan.seed,
                                    scenario=self.plan.scenario, episodes=episodes, **parameters)

    def share(self):
        """Lets all agents be known to the learner by one tick, and copies the table of agent 0 to all others."""
        nodes = self.nodes
        nodes.call('learner/set_mode', srv.SetMode, mode='demo')  # nothing is learned from that tick
        nodes.call('crowd_controller/step', srv.Step, ticks=1)
        if self.plan.training != WATCHED:  # the learner does not have the table yet
            table = pathlib.Path(self.plan.file(LEARNED)).read_text(encoding='utf-8')
            nodes.call('learner/take_q_table', srv.TakeQTable, to_agents=[0], method='replace', q_table=table)
        answer = nodes.call('learner/share_q_table', srv.ShareQTable, from_agent=0, method='replace')
        print(f'share_q_table: {answer.message}', flush=True)
        nodes.call('crowd_controller/reset', srv.Reset, keep_seed=True)
        nodes.call('crowd_controller/save_scenario', srv.SaveScenario, file=SCENE, overwrite=True)

    def let_walk(self):
        """Lets the crowd walk and, maybe, go on learning."""
        if self.plan.learning:
            self.nodes.call('learner/set_learning_parameters', srv.SetLearningParameters,
                            parameters=f'{{epsilon: {self.plan.crowd_epsilon}}}')
            self.nodes.call('learner/set_mode', srv.SetMode, mode='training')
        plural = '' if self.plan.episodes == 1 else 's'
        print(f'the crowd walks: {self.plan.episodes} episode{plural} of {self.name()}, '
              f'{"and goes on learning" if self.plan.learning else "without learning"}', flush=True)
        self.has_begun = True
        self.nodes.call('crowd_controller/pause', SetBool, data=False)

    def print_figures(self):
        """Prints the figures of the training and of the crowd's episodes so far."""
        self.has_begun = False
        write_record(self.plan.file(CROWD), self.nodes.results)
        columns = [*((part.name, part.record) for part in PARTS), (self.name(), CROWD)]
        table_of('Figures', [(title, self.plan.file(file)) for title, file in columns]).print()
        print(f'\ntables and records: {self.plan.folder}', flush=True)

    def end(self):
        """Ends the nodes, so that the learner saves the tables; after an interruption, prints the figures."""
        self.nodes.stop()
        if rospy.is_shutdown() and self.has_begun and self.nodes.results:
            self.print_figures()


def main():
    try:
        rospy.init_node('show_thesis')
    except rospy.ROSInitException:
        if rospy.is_shutdown():  # interrupted during initialisation
            return 0
        raise
    show = None
    try:
        show = Show(read_plan())
        try:
            show.run()
        finally:
            show.end()
    except Stopped:
        return 0
    except (InputError, NodeError, OSError, rospy.ROSException, rospy.ServiceException) as error:
        if rospy.is_shutdown():  # a service was interrupted
            return 0
        rospy.logfatal('%s', problem_of(error))
        return 1
    end_launch()
    return 0
