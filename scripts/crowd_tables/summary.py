"""One number for each row of a Q-table."""
import numpy


def row_visits(table):
    """Returns the number of visits of each row."""
    return table.visits.sum(axis=1)


def row_values(table, kind):
    """Returns the value of each row; nan if it was not visited.

    If all actions share a row, as in most state sets, it is the highest value of a visited action: what the agent
    expects there. With `anticipation` each action has a row of its own: the mean over actions, weighted by visits."""
    visited = table.visits > 0
    known = visited.any(axis=1)
    if kind == 'anticipation':
        weighed = (table.visits * table.values).sum(axis=1)
        return numpy.divide(weighed, row_visits(table), out=numpy.full(len(known), numpy.nan), where=known)
    return numpy.where(known, numpy.where(visited, table.values, -numpy.inf).max(axis=1), numpy.nan)


def greedy_actions(table):
    """Returns the action with the highest value in each row, as an agent chooses it: the first one of several, actions
    without a visit having the value 0."""
    return table.values.argmax(axis=1)
