"""Kinds of faults. Each function applies a fault to a graph and takes its cause away again."""
import signal
import time

from .graph import SHARES
from .relay import FAULTS, REMAPPINGS, Relay

LONGEST = 0.7  # [s] until the cause of a fault is gone: longer than it takes until learners are absent
RELAYED_TICKS = 10  # with faults of messages


def pause(draw):
    time.sleep(draw.uniform(0.0, LONGEST))


def some_learner(draw):
    """Returns a learner and its share."""
    share = draw.randrange(SHARES)
    return f'learner_{share}', share


def learner_killed(graph, draw):
    name, share = some_learner(draw)
    graph.end(name, signal.SIGKILL)
    pause(draw)
    graph.start_learner(name, share=share)


def other_table(graph, draw):
    """A learner comes back with a table of another state set."""
    name, share = some_learner(draw)
    graph.end(name)
    graph.start_learner(name, share=share, table=graph.other_table)


def learner_interrupted(graph, draw):
    """A further learner is interrupted while it starts, or soon after."""
    graph.start_learner('learner_new', share=draw.randrange(SHARES))
    pause(draw)
    graph.end('learner_new')


def learner_twice(graph, draw):
    """Another learner answers for the same agents."""
    graph.wait_for(lambda: graph.status, 'a status')
    before = graph.status.dropped_answers
    graph.start_learner('learner_twin', share=draw.randrange(SHARES))
    graph.wait_for(lambda: graph.status.dropped_answers > before, 'dropped answers')
    graph.end('learner_twin')


def same_name(graph, draw):
    """A learner of the same name is started, with which the master ends the first one."""
    name, share = some_learner(draw)
    first = graph.nodes[name]
    graph.start_learner(name, share=share)
    graph.wait_end(name, first)


def stopped(name):
    """Returns a fault: a node hangs for a while."""
    def stop(graph, draw):
        process = graph.nodes[name]
        process.send_signal(signal.SIGSTOP)
        pause(draw)
        process.send_signal(signal.SIGCONT)
    return stop


def learner_stopped(graph, draw):
    stopped(some_learner(draw)[0])(graph, draw)


def controller_restarted(number):
    """Returns a fault: the controller is ended by a signal and started again."""
    def restart(graph, draw):
        graph.end('controller', number)
        pause(draw)
        graph.start_controller()
    return restart


def master_gone(graph, draw):
    """Without a master connected nodes go on. They register with the next one."""
    graph.end('master', draw.choice([signal.SIGKILL, signal.SIGINT]))
    graph.wait_until_steady()
    return_master(graph)


def master_and_learner_gone(graph, draw):
    """The learner is started again before there is a master."""
    name, share = some_learner(draw)
    graph.end('master', signal.SIGKILL)
    graph.end(name, signal.SIGKILL)
    graph.start_learner(name, share=share)
    pause(draw)
    return_master(graph)


def return_master(graph):
    graph.start_master()
    graph.wait_for(graph.is_registered, 'the registrations')
    graph.listen()


def relayed(fault):
    """Returns a fault: for a while one learner decides for all agents, behind a relay."""
    def relay_messages(graph, draw):
        for share in range(SHARES):
            graph.end(f'learner_{share}')
        with Relay(fault, draw.randrange(2**31)) as relay:
            graph.start_learner('learner_relayed', *REMAPPINGS)
            graph.wait_for(lambda: graph.status, 'a status')
            begin = graph.status
            graph.wait_for(lambda: graph.status.decisions > begin.decisions, 'answers through the relay')
            begin = graph.status
            graph.wait_for(lambda: graph.status.tick >= begin.tick + RELAYED_TICKS, 'ticks with the relay')
            relay.heal()
            graph.wait_until_steady()
            graph.end('learner_relayed')
        graph.start_learners()
    return relay_messages


# Functions, and how often they are drawn: a long life of nodes between two of their ends shows what they leak.
KINDS = {
    'learner_killed': (learner_killed, 6), 'learner_stopped': (learner_stopped, 6),
    'learner_interrupted': (learner_interrupted, 6), 'learner_twice': (learner_twice, 6), 'same_name': (same_name, 6),
    'other_table': (other_table, 6), 'controller_stopped': (stopped('controller'), 6),
    'controller_killed': (controller_restarted(signal.SIGKILL), 1),
    'controller_interrupted': (controller_restarted(signal.SIGINT), 1),
    'master_gone': (master_gone, 1), 'master_and_learner_gone': (master_and_learner_gone, 1),
    **{f'messages_{fault}': (relayed(fault), 3) for fault in FAULTS}}
