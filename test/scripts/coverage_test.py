"""research/coverage: shares by folder, with a substitute for the programs that it starts."""
import json
import os

import pytest
from programs import in_package

# Stands for cmake, gcovr and tests; writes the summary that is asked for.
PROGRAM = '''#!/bin/bash
while (($# > 0)); do
  [[ $1 != --json-summary ]] || cp "$(dirname "$0")/summary" "$2"
  shift
done
'''


class CoverageTest:
    """The complete program."""

    @pytest.mark.parametrize('covered, status', [(95, 0), (94, 1)])
    def test_shares_by_folder(self, runner, covered, status):
        """285 of 300 lines are 95 %, 17 of 20 branches 85 %."""
        keys = ('line_covered', 'line_total', 'branch_covered', 'branch_total')
        files = [dict(zip(keys, counts), filename=name) for name, counts in
                 {'src/maps/a.cpp': (90, 100, 8, 10), 'src/maps/b.cpp': (100, 100, 0, 0),
                  'src/world/c.h': (covered, 100, 9, 10)}.items()]
        runner.write('summary', json.dumps({'files': files}))
        for name in ('cmake', 'gcovr', *(f'{layer}_test' for layer in os.listdir(in_package('src')))):
            os.chmod(runner.write(name, PROGRAM), 0o755)
        runner.environment['PATH'] = f"{runner.folder}:{os.environ['PATH']}"
        os.mkdir(runner.path('build'))
        running = runner.start('coverage', [in_package('research', 'coverage'), '--folder', runner.path('build'),
                                            '--tests', runner.folder])
        assert running.wait() == status, running.output()
        assert running.output().splitlines()[1:3] == [
            'maps           95.0     80.0', f'world          {covered}.0     90.0']
