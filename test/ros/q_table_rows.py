"""Small Q-tables and the rows of saved ones."""
import support
from learning_files import QTableFile

TABLE_A = {0: {0: (3, 1.0)}, 5: {2: (7, -2.5)}}  # {row: {action: (visits, value)}}
TABLE_B = {0: {0: (1, 5.0)}, 9: {1: (2, 0.25)}}
MERGED = {0: {0: (4, 2.0)}, 5: {2: (7, -2.5)}, 9: {1: (2, 0.25)}}  # means weighted by visits; visits add up


def full(rows):
    """Returns rows in the form of a file, with all actions."""
    return {row: [actions.get(action, (0, 0.0)) for action in range(8)] for row, actions in rows.items()}


class TableTestCase(support.CrowdTestCase):
    """Reads tables of learners by saving them."""

    def saved(self, learner, agent=0):
        """Returns the rows of an agent's table."""
        file = self.path('saved.txt')
        self.succeed(f'{learner}/save_q_table', file=file, agent=agent, overwrite=True)
        return QTableFile(file).rows
