"""Scripts with files that they cannot read: one line that names the file, no traceback."""
import itertools
import os
import random
import sys

import pytest
from crowd_experiments.interruption import run_program
from programs import CIRCLE6, NEAREST_TABLE, read_text

PATHS = 'instance,tick,agent,x,y\n' + ''.join(f'0,{tick},0,{tick / 10},0.5\n' for tick in range(9))
LOG = 'episode,scenario,agents,success,decisions\n0,a,1,1,120\n1,a,1,1,120\n'
ROBOTS = '{"tick_duration": 1, "robots": [{"radius": 0.2}]}\n{"tick": 0, "robots": [{"x": 0, "y": 0, "heading": 0}]}\n'
OBSMAT = ''.join(f'{780 + 6 * step} {person} {step / 2} 0 {person} 0.1 0 0.2\n' for step in range(5)
                 for person in (1, 2))
SCENE = '''<scenario>
  <waypoint id="west" x="2" y="5" r="1.5"/>
  <agent x="4" y="5" n="3" dx="2" dy="4" type="0"/>
</scenario>
'''
SWEEP = f'q_table: {NEAREST_TABLE}\nseeds: 2\nevaluate: {{scenarios: [circle6], episodes: 1}}\n'
# Module, arguments with FILE, and contents of a good file, by program.
PROGRAMS = {
    'plot_paths': ('crowd_drawing.paths_program',
                   ['--trajectories', 'FILE', '--scenario', CIRCLE6, '--output', 'a.png'], PATHS),
    'plot_learning': ('crowd_curves.program', ['FILE', '--output', 'a.png'], LOG),
    'film': ('crowd_film.program', ['--trajectories', 'FILE', CIRCLE6, '--output', 'a.gif'], PATHS),
    'export': ('crowd_export.program', ['--trajectories', 'FILE', '--gltf', 'a.glb'], PATHS),
    'report': ('crowd_report.program', ['FILE', '--output', 'a.html'], PATHS),
    'report_training': ('crowd_report.program', ['--training', 'FILE', '--output', 'a.html'], LOG),
    'realism': ('crowd_realism.program', ['FILE'], OBSMAT),
    'convert_trajectories': ('crowd_recordings.formats', ['FILE', '--output', 'a.csv'], ROBOTS),
    'sweep': ('crowd_sweep.plan', ['FILE', '--dry-run'], SWEEP),
    'draw_q_table': ('crowd_tables.program', ['FILE', '--output', 'a.png'], read_text(NEAREST_TABLE)),
    'pedsim_import': ('crowd_import.program', ['FILE', '--output', 'a.yaml'], SCENE),
}
CONTENTS = {
    'empty': lambda _: b'',
    'bytes': lambda _: bytes(random.Random(1).randrange(256) for _ in range(2000)),
    'zeros': lambda _: bytes(2000),
    'folder': lambda _: None,
    'cut': lambda good: good[:len(good) * 2 // 3].encode(),
    'not a number': lambda good: good.replace('0', 'x').encode(),
    'infinite': lambda good: good.replace('0', 'inf').encode(),
    'huge': lambda good: good.replace('0', '9e307').encode(),
}
# A log may still be written; this sweep has no other numbers.
FINE = [('plot_learning', 'cut'), *(('sweep', kind) for kind in ('not a number', 'infinite', 'huge'))]


class BadFilesTest:
    """Exit status 1 and a line with the name of the program and of the file."""

    @pytest.mark.parametrize('name, kind', sorted({*itertools.product(PROGRAMS, CONTENTS)}.difference(FINE)))
    def test_scripts(self, runner, monkeypatch, capsys, name, kind):
        module, words, good = PROGRAMS[name]
        monkeypatch.chdir(runner.folder)
        content = CONTENTS[kind](good)
        if content is None:
            os.mkdir('given')
        else:
            with open('given', 'wb') as stream:
                stream.write(content)
        monkeypatch.setattr(sys, 'argv', [name, *(word.replace('FILE', 'given') for word in words)])
        status = run_program(name, module)
        said = capsys.readouterr().err
        print(said)
        assert status == 1 and said.startswith(f'{name}: given') and said.count('\n') == 1
        assert os.listdir() == ['given']
