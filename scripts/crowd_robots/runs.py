"""Episodes of the benchmark: runs of `evaluate`, and records of robots that were driven elsewhere."""
import dataclasses
import pathlib
import shutil

import yaml

from crowd_experiments.runs import Run

from .catalogue import CROWDNAV, INVISIBLE, VISIBLE
from .measures import read_record

RECORD = 'robots.csv'  # in a run's folder


@dataclasses.dataclass(frozen=True)
class Benchmark:
    """The tool, the Q-table of the people, and the folder of all results."""
    evaluate: pathlib.Path
    q_table: pathlib.Path
    scenarios: pathlib.Path  # folder of the scenario files
    output: pathlib.Path
    placements: int
    crowdnav_episodes: int

    def run_of(self, controller, scenario):
        """Returns the run of a scenario."""
        return self.run(controller, scenario, self.scenarios / f'{scenario}.yaml', self.placements)

    def crowdnav_runs(self, controller):
        """Returns the runs in CrowdNav's setting: people see the robot, or not."""
        visible = self.scenarios / f'{CROWDNAV}.yaml'
        return {VISIBLE: self.run(controller, 'crowdnav_visible', visible, self.crowdnav_episodes),
                INVISIBLE: self.run(controller, 'crowdnav_invisible', self.invisible(visible), self.crowdnav_episodes)}

    def run(self, controller, name, scenario, episodes):
        command = [self.evaluate, '--q-table', self.q_table, '--robot', controller, '--people-delay', '--episodes',
                   episodes, '--threads', 1, '--robots-csv', RECORD, scenario]
        return Run(self.output / 'runs' / controller / name, [command], float(episodes))

    def invisible(self, scenario):
        """Writes a scenario whose robots people do not see. Returns its file."""
        document = yaml.safe_load(scenario.read_text(encoding='utf-8'))
        for robot in document['robots']:
            robot['perceived'] = False
        file = self.output / 'scenarios' / f'{scenario.stem}_invisible.yaml'
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(yaml.safe_dump(document, sort_keys=False), encoding='utf-8')
        return file

    def others(self):
        """Returns the stored records of robots that were driven elsewhere, by their names."""
        return {file.stem: read_record(file) for file in sorted((self.output / 'others').glob('*.csv'))}

    def store(self, robot, file):
        """Checks a record of a robot that was driven elsewhere, and stores it under the robot's name."""
        read_record(file)
        kept = self.output / 'others' / f'{robot}.csv'
        kept.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, kept)
