"""The command line of research/bench_sweeps."""
from crowd_bench import program

from .sweeps import RANK_SWEEPS, SWEEPS


def main(words=None):
    """Runs the program with command line words. Returns the exit status."""
    return program.main(words, {'sweeps': (*SWEEPS, *RANK_SWEEPS)}, 'research/bench_sweeps crowd_step_agents')
