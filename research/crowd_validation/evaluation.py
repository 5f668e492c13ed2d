"""Runs evaluate with the scenarios of a case."""
import dataclasses
import pathlib

import yaml

from crowd_experiments.runs import Run, Runner

from .plan import TICK
from .recording import read_recording

DUMPER = getattr(yaml, 'CSafeDumper', yaml.SafeDumper)


@dataclasses.dataclass(frozen=True)
class Evaluation:
    """The tool, the Q-table, and the folder and the seeds of a case. Results of earlier runs with the same program,
    table and scenario are used again."""
    evaluate: pathlib.Path
    q_table: pathlib.Path
    folder: pathlib.Path
    seeds: int
    processes: int = 1

    def seed_numbers(self):
        """Returns the seeds 1, 2, ..."""
        return range(1, self.seeds + 1)

    def walk(self, plans):
        """Runs one episode of every plan with every seed. `plans` are functions of the seed that return a scenario
        document, by the names of the scenarios. Returns lists of Recordings, one for each seed, by these names.

        Raises RunError with the tool's message if it fails."""
        runs = {(name, seed): self.run_of(name, plan(seed), seed)
                for name, plan in plans.items() for seed in self.seed_numbers()}
        left = [run for run in runs.values() if not run.is_done()]
        if left:
            Runner(self.processes).carry_out(left)
        return {name: [read_recording(runs[name, seed].folder, name, TICK) for seed in self.seed_numbers()]
                for name in plans}

    def run_of(self, name, document, seed):
        """Writes the scenario file of a run, and returns the run."""
        file = self.folder / 'scenarios' / f'seed_{seed}' / f'{name}.yaml'
        file.parent.mkdir(parents=True, exist_ok=True)
        text = yaml.dump(document, None, DUMPER, sort_keys=False, default_flow_style=None, width=120)
        file.write_text(text, encoding='utf-8')
        command = [self.evaluate, '--q-table', self.q_table, '--seed', seed, '--threads', 1, '--trajectories',
                   'trajectories', '--scenes', 'scenes', '--record', 'record.csv', file]
        walked = sum(entry.get('count', 1) for entry in document.get('agents', [])) * document['duration']
        return Run(self.folder / 'runs' / f'{name}_{seed}', [command], max(1.0, walked / 20000.0))
