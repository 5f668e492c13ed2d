"""Logs of robots among people as recordings: read, filmed, drawn."""
import json
import math
import pathlib

import pytest
from crowd_drawing import paths_program
from crowd_drawing.errors import InputError
from crowd_film.program import Settings, frame_times
from crowd_film.stage import FOOT, FramePainter, Stage
from crowd_recordings.formats import read_recording, read_shown
from crowd_recordings.robot_log import read_robot_log

HEADER = {'scenario': 'hall', 'episode': 3, 'tick_duration': 0.5, 'walls': [[-1, -2, 5, -2]],
          'robots': [{'name': 'tug', 'radius': 0.4}]}
ROBOT_COLOUR, WHITE = (242, 169, 0), (255, 255, 255)


def lines_of(*entries):
    return ''.join(json.dumps(entry) + '\n' for entry in entries)


def tick(number, x, heading, *people):
    return {'tick': number, 'robots': [{'x': x, 'y': 0, 'heading': heading}], 'people': list(people)}


# The robot drives from (0, 0) to (4, 0) in 1 s and turns across 180 degrees; person 7 is there in two of three ticks.
LOG = lines_of(HEADER, tick(0, 0, math.pi - 0.1, {'id': 7, 'x': 1, 'y': 3, 'radius': 0.3}),
               tick(1, 2, -math.pi + 0.1, {'id': 7, 'x': 2, 'y': 3}), tick(2, 4, -math.pi + 0.3))
OTHER = lines_of({**HEADER, 'episode': 4}, tick(0, 9, 0))


class RobotLogTest:

    def test_people_and_robots(self, runner):
        scene, tracks, duration = read_shown(runner.write('log.jsonl', LOG + OTHER))
        assert duration == 0.5
        assert list(tracks) == [7]
        assert tracks[7].place_at(0.25) == [1.5, 3.0]
        assert tracks[7].is_present(0.5) and not tracks[7].is_present(1.0)
        assert scene.radius_of(7) == 0.3
        assert scene.walls == [[(-1, -2), (5, -2)]]
        robot, = scene.robots
        assert robot['radius'] == 0.4
        assert robot['track'].place_at(0.75) == [3.0, 0.0]
        # The heading goes on beyond 180 degrees.
        assert robot['track'].heading_at(0.25) == pytest.approx(math.pi)
        assert robot['track'].heading_at(1.0) == pytest.approx(math.pi + 0.3)

    def test_episodes(self, runner):
        file = runner.write('log.jsonl', LOG + OTHER)
        assert read_robot_log(file).episode == 3
        assert read_robot_log(file, 4).robots == [[(0, 9.0, 0.0, 0.0)]]
        with pytest.raises(InputError, match=r'log.jsonl: has no episode 5, expected 3, 4'):
            read_robot_log(file, 5)
        assert read_recording(file).walks == {7: [(0, 1, 3), (1, 2, 3)]}

    @pytest.mark.parametrize('text, words', [
        (lines_of(tick(0, 0, 0)), 'log:1: expected a line of a log of robots'),
        (lines_of(HEADER), 'log: the episode has no ticks'),
        (lines_of(HEADER, {'tick': 0, 'robots': []}), 'log:2: expected a line of a log of robots'),
        (lines_of(HEADER, tick(0, math.nan, 0)), 'log:2: expected a line of a log of robots'),
        (lines_of({**HEADER, 'tick_duration': 0}), 'log:1: expected a line of a log of robots'),
        (LOG + '{"tick": 3,\n', "log:5: expected a line of a log of robots, as of `evaluate --robot-log`, got"),
        (LOG[:-5], 'log:4: the last line is not complete'),
    ])
    def test_errors(self, runner, text, words):
        with pytest.raises(InputError) as caught:
            read_recording(runner.write('log', text))
        assert words in str(caught.value)


class PictureTest:

    def test_a_film_shows_the_robot_where_it_is(self, runner):
        scene, tracks, _ = read_shown(runner.write('log.jsonl', LOG))
        times = frame_times(Settings(pathlib.Path('a.gif'), 'hall', speed=0.5, fps=1), tracks)
        assert times == [0.0, 0.5]  # until person 7 leaves
        stage = Stage(scene, tracks, 'hall', 600)
        painter = FramePainter(stage, scene, tracks)

        def pixel(frame, x, y):
            axes = stage.picture.axes
            return tuple(frame[int(stage.height - FOOT - (y - axes.get_ylim()[0]) * stage.scale),
                               int((x - axes.get_xlim()[0]) * stage.scale)])
        frame = painter.draw(0.75)  # at (3, 0), looking to the left
        assert pixel(frame, 3.2, 0.1) == ROBOT_COLOUR
        assert pixel(frame, 0.2, 0.1) == WHITE

    def test_paths_of_people_and_robots(self, runner, capsys):
        log = runner.write('log.jsonl', LOG)
        scenario = runner.write('hall.yaml', 'name: hall\ntick: 0.5\nagents: []\nsources: [{area: {box: [[0, 0], '
                                '[1, 1]]}, rate: 1, radius: 0.3, goal: [4, 0]}]\n'
                                'robots: [{name: tug, position: [0, 0], radius: 0.4, max_speed: 4}]\n')
        picture = pathlib.Path(runner.path('paths.png'))
        paths_program.main(['--trajectories', str(log), '--scenario', str(scenario), '--output', str(picture)])
        assert picture.read_bytes().startswith(b'\x89PNG')
        assert capsys.readouterr().err == ''
