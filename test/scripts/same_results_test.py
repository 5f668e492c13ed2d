"""research/same_results: what it compares, and how it shortens scenarios."""
import pathlib

from crowd_studies import same_results
from programs import tools_folder


class SameResultsTest:
    """Its parts, and a run with the present build in place of another compiler's."""

    def test_each_byte_and_file_counts(self):
        ours = {'a.csv': b'x\n1\n2\n', 'b.csv': b'x\n1\n'}
        assert same_results.differences(ours, dict(ours)) == []
        assert same_results.differences(ours, {'a.csv': b'x\n1\n3\n', 'b.csv': b'x\n1\n'}) == [
            'a.csv: differs from line 3 on']
        assert same_results.differences(ours, {'a.csv': b'x\n1\n2\n', 'c.csv': b'x\n1'}) == [
            'b.csv: written by one of the builds only', 'c.csv: written by one of the builds only']
        assert same_results.differences({'b.csv': b'x\n1\n'}, {'b.csv': b'x\n1'}) == ['b.csv: differs from line 2 on']

    def test_long_episodes_are_shortened(self):
        text = 'name: a\nduration: 400\nagents: []\n---\nduration: 20.5\n'
        assert same_results.shortened(text, 60.0) == 'name: a\nduration: 60\nagents: []\n---\nduration: 20.5\n'
        thesis = 'units: thesis\nduration: 2000\n'
        assert same_results.shortened(thesis, 60.0) == thesis

    def test_run(self, tmp_path, monkeypatch, capsys):
        tools = pathlib.Path(tools_folder())
        monkeypatch.setattr(same_results, 'build', lambda compiler, folder: tools)
        words = ['--folder', str(tmp_path), '--tools', str(tools), '--compiler', 'other', '--table', 'human',
                 '--scenario', 'circle6', '--seconds', '1']
        assert same_results.main(words) == 0
        assert 'other: 3 of 3 files (0 MB) are the same' in capsys.readouterr().out
        changed = tmp_path / 'runs' / 'other' / 'human' / 'circle6' / 'agents.csv'
        changed.write_bytes(changed.read_bytes() + b'0')
        assert same_results.main(words) == 1
        assert 'human/circle6/agents.csv: differs from line' in capsys.readouterr().out
