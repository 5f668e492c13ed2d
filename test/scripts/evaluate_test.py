"""evaluate: arguments that do not fit the scenario, or each other."""
import os
import subprocess

from programs import PATIENCE, assert_says, tools_folder


def evaluate(*arguments):
    """Runs evaluate with a shipped table. Returns exit status and what it says beside the metrics."""
    done = subprocess.run([os.path.join(tools_folder(), 'evaluate'), '--q-table', 'anticipation', *arguments],
                          stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                          timeout=PATIENCE, check=False)
    return done.returncode, done.stderr.decode()


class ArgumentsTest:
    """Exit status 2 and a message, or a warning."""

    def test_a_robot_that_the_scenario_does_not_have(self):
        status, said = evaluate('--robot', 'orca', 'circle6')
        assert status == 0
        assert_says(said, 'evaluate: warning: ', 'circle6.yaml has no robot for --robot')
        assert 'has no robot' not in evaluate('--robot', 'orca', 'robot_frontal')[1]

    def test_options_that_are_not_used_with_the_page(self):
        status, said = evaluate('--web', '--csv', 'metrics.csv', 'circle6')
        assert status == 2
        assert_says(said, '--csv: is not used with --web')

    def test_one_scenario_for_the_page(self):
        status, said = evaluate('--web', 'circle6', 'circle12')
        assert status == 2
        assert_says(said, '--web: expected one SCENARIO')

    def test_folders_of_files_of_the_same_names(self, tmp_path):
        folder = tmp_path / 'recorded'
        for same in (folder, f'{folder}/', f'{folder}/../recorded'):
            status, said = evaluate('--trajectories', folder, '--robot-series', same, 'robot_frontal')
            assert status != 0
            assert_says(said, '--robot-series: expected another folder than that of --trajectories, got')
            assert not folder.exists()
