"""Runs the benchmarks of a crowd and of a training on several ranks, programs for mpirun."""
import json
import os
import shutil
import statistics
import subprocess

from crowd_experiments.runs import RunError

PROGRAM = 'rank_benchmarks'
TRAINING = 'rank_training'
LEARNERS = 16
RANKS = 2
AGENTS = 100_000
# Rates of the yardsticks in the program's output, by benchmark.
YARDSTICKS = {'crowd_step_mpi_2': 'threads_rate', 'crowd_step_mpi_2_parts': 'parts_rate',
              'train_mpi_2': 'threads_rate'}


def run(folder, benchmark, repetitions):
    """Returns the result of a benchmark; None without mpirun. The ratio is the median of the ratios of the repetitions,
    in which crowd and yardsticks take turns."""
    if shutil.which('mpirun') is None:
        return None
    program, size = (TRAINING, LEARNERS) if benchmark.name == 'train_mpi_2' else (PROGRAM, AGENTS)
    runs = measure(folder / program, RANKS, size, benchmark.repetitions or repetitions)
    values = [each['rate'] for each in runs]
    yardsticks = [each[YARDSTICKS[benchmark.name]] for each in runs]
    ratios = [benchmark.ratio(*pair) for pair in zip(values, yardsticks)]
    return benchmark.result(*map(statistics.median, (values, yardsticks, ratios)), (min(values), max(values)))


def measure(program, ranks, size, repetitions):
    """Returns the measurements of each repetition, with this number of agents or learners.
    Ranks that wait give way to the threads of others."""
    done = subprocess.run(
        ['mpirun', '--oversubscribe', '--allow-run-as-root', '--bind-to', 'none', '-n', str(ranks), program,
         str(size), str(repetitions)],
        env={**os.environ, 'OMPI_MCA_mpi_yield_when_idle': '1'}, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise RunError(f'{program} failed:\n{done.stdout}{done.stderr}')
    return [json.loads(line) for line in done.stdout.splitlines()]
