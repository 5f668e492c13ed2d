"""research/graph_faults and research/graph_load: each kind of fault in a running graph, and a subscriber that hangs."""
import re
import sys

from programs import in_package, wait_for

sys.path.append(in_package('research'))
from crowd_faults.faults import KINDS  # noqa: E402

LIMIT = 900.0  # [s]; 60 s on an idle machine


def run(runner, program, *words):
    """Runs a program of research/ to its end. Returns its output."""
    process = runner.start(program, [in_package('research', program), *words])
    assert process.wait(LIMIT) == 0, process.output()
    return process.output()


class GraphFaultsTest:
    """A short run of each program. graph_faults checks after each fault that the crowd goes on."""

    def test_faults_of_each_kind(self, runner):
        output = run(runner, 'graph_faults', '--faults', str(len(KINDS) + 5), '--answer-deadline', '1')
        assert set(re.findall(r'^\| (\w+) ', output, re.MULTILINE)) == {'fault', 'all', *KINDS}

    def test_interrupted_run_prints_the_table(self, runner):
        process = runner.start('graph_faults', [in_package('research', 'graph_faults'), '--kinds', 'learner_stopped'])
        wait_for(lambda: 'learner_stopped' in process.output(), 'a fault')
        process.stop()
        assert process.process.returncode == 130
        assert re.search(r'^\| all \| \d+ ', process.output(), re.MULTILINE)
        process.is_given_up = True

    def test_subscriber_that_never_reads(self, runner):
        output = run(runner, 'graph_load', '--agents', '100', '--factor', '20', '--subscribers', '5', '--seconds', '2',
                     '--period', '1')
        assert 'were read by 4 subscribers' in output
