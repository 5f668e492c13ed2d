"""A learner that gets its perceptions from a test."""
import support
from learning_files import QTableFile, config_text
from perceiving import Perceiver, add_agent, ahead, perceptions
from social_crowd.msg import LearnerStatus


class LearnerTestCase(support.CrowdTestCase):
    """One learner, and a Perceiver in place of the crowd controller."""

    def start_one(self, **parameters):
        """Starts the learner."""
        self.status = self.listen('learner_status', LearnerStatus)
        self.start_learner(**parameters)
        self.perceiver = Perceiver(self)
        self.status.wait()

    def start_untrained(self, **parameters):
        """Starts a learner with an empty table and without exploration."""
        config = self.write('config.yaml', config_text(support.CIRCLE6, 1))
        self.start_one(config=config, mode='training', epsilon=0.0, **parameters)

    def saved(self):
        """Returns the learner's table."""
        self.succeed('learner/save_q_table', file=self.path('saved.txt'), overwrite=True)
        return QTableFile(self.path('saved.txt'))

    def walk(self, episode, ticks, acted=True):
        """Publishes ticks of an agent whose goal is 45 degrees to the left. Returns the answers."""
        return [self.perceiver.ask(add_agent(perceptions(episode, tick), 0, ahead(45, 5), acted=acted))
                for tick in range(ticks)]
