"""Frames and files of films: what is drawn, and when."""
import math
import os
import pathlib

import numpy
import pytest
from crowd_film.stage import DPI, FOOT, FramePainter, Stage
from crowd_film.pictures import write_gif, write_mp4
from crowd_film.program import Settings, frame_times
from crowd_recordings.formats import read_shown, track_of
from film_files import LINE, WALKS, frames_of


class TrackTest:
    """Positions between ticks."""

    def test_between_two_ticks(self):
        track = track_of([(0, 0, 0), (1, 1, 2), (2, 1, 4)], 0.5)
        assert track.place_at(0.25) == [0.5, 1.0]
        assert track.place_at(9) == [1.0, 4.0]
        assert [track.is_present(time) for time in (-0.1, 0, 1, 1.1)] == [False, True, True, False]
        assert track.trail(1.0, 0.5, 3).tolist() == [[1, 2], [1, 3], [1, 4]]

    def test_heading_of_the_recent_motion(self):
        """Right, up, and then it stands: the heading stays up. Before the first step it is that of the first step."""
        walk = [*((tick, tick, 0) for tick in range(10)), *((tick, 9, tick - 9) for tick in range(10, 20)),
                *((tick, 9, 10) for tick in range(20, 30))]
        track = track_of(walk, 0.1)
        assert [track.heading_at(time) for time in (0, 0.5)] == [0, 0]
        assert [track.heading_at(time) for time in (1.5, 2.8)] == pytest.approx([math.pi / 2] * 2)

    def test_headings_are_continuous(self):
        """From 170 to -170 degrees it turns by 20 degrees, not by 340."""
        steps = [(math.cos(math.radians(angle)), math.sin(math.radians(angle))) for angle in [170] * 10 + [190] * 10]
        places = numpy.vstack([[0, 0], numpy.cumsum(steps, axis=0)])
        headings = track_of([(tick, *place) for tick, place in enumerate(places)], 0.1).headings
        assert numpy.abs(numpy.diff(headings)).max() < math.radians(21)

    def test_an_agent_that_stands(self):
        assert track_of([(0, 1, 1), (1, 1, 1)], 0.1).headings.tolist() == [0, 0]


class FrameTest:
    """The pixels of a frame."""

    def painter(self, runner):
        scene, tracks, _ = read_shown(runner.write('line.csv', WALKS), runner.write('line.yaml', LINE))
        stage = Stage(scene, tracks, 'line', 600)
        return FramePainter(stage, scene, tracks), stage

    def pixel(self, stage, frame, x, y):
        """Returns the colour of a point in metres."""
        axes = stage.picture.axes
        column = (x - axes.get_xlim()[0]) * stage.scale
        row = stage.height - FOOT - (y - axes.get_ylim()[0]) * stage.scale
        return tuple(frame[int(row), int(column)])

    def test_people_and_obstacles_are_where_they_were(self, runner):
        """After 3 s agent 0 is at (3, 0), with a trail behind it, the obstacle is at (3.5, -2), agent 1 has gone."""
        painter, stage = self.painter(runner)
        frame = painter.draw(3.0)
        assert frame.shape == (stage.height, stage.width, 3)
        assert stage.width == 600 or stage.height == 600
        white, blue, grey = (255, 255, 255), (31, 119, 180), (158, 158, 158)
        assert self.pixel(stage, frame, 2.7, 0.2) == blue
        assert self.pixel(stage, frame, 3.9, -2) == grey
        assert self.pixel(stage, frame, 2, -2) == white
        trail = self.pixel(stage, frame, 2.0, 0)
        assert trail not in (white, blue)
        assert self.pixel(stage, frame, 0, 3.1) == white  # only the outline of agent 1, who stood at (0, 3)
        assert self.pixel(stage, painter.draw(1.0), 0, 3.15) == (214, 39, 40)

    def test_nothing_of_the_last_frame_remains(self, runner):
        painter, _ = self.painter(runner)
        first = painter.draw(1.0)
        painter.draw(4.0)
        assert (painter.draw(1.0) == first).all()

    def test_a_gif_shows_what_was_drawn(self, runner):
        """Up to its palette; unchanged pixels are transparent in the file."""
        painter, _ = self.painter(runner)
        drawn = [painter.draw(time) for time in (0, 1, 1.5, 1.5, 4)]
        write_gif(runner.path('film.gif'), iter(drawn), drawn, 100)
        shown = frames_of(runner.path('film.gif'))
        assert len(shown) == len(drawn)
        assert (shown[0][0, 0] == 255).all()
        for got, expected in zip(shown, drawn):
            difference = numpy.abs(got.astype(int) - expected.astype(int)).max(axis=2)
            assert numpy.mean(difference > 40) < 0.002, numpy.mean(difference > 40)

    def test_unchanged_pixels_cost_nothing(self, runner):
        painter, _ = self.painter(runner)
        first, other = painter.draw(0), painter.draw(0.2)
        for name, count in (('short', 1), ('long', 9)):
            write_gif(runner.path(f'{name}.gif'), iter([first] + [other] * count), [first, other], 100)
        size = {name: os.path.getsize(runner.path(f'{name}.gif')) for name in ('short', 'long')}
        assert size['long'] < 1.2 * size['short']

    def test_people_with_large_numbers(self, runner):
        """The numbers of a recording's people are arbitrary; memory is that of the people."""
        rows = ''.join(f'{frame} {person} {frame / 10} 0 {person % 7} 0 0 0\n'
                       for frame in range(3) for person in (5, 10**12))
        scene, tracks, _ = read_shown(runner.write('obsmat.txt', rows))
        painter = FramePainter(Stage(scene, tracks, 'people', 600), scene, tracks)
        assert set(painter.colours) == {5, 10**12}
        assert painter.colours[5] != painter.colours[10**12]

    def test_gates(self, runner):
        """An open gate is a dotted line, with fewer pixels of its colour."""
        gate = 'gates: {door: {wall: [[0, 1], [4, 1]], open: [[1, 2]]}}\n'
        scene, tracks, _ = read_shown(runner.write('line.csv', WALKS), runner.write('line.yaml', LINE + gate))
        painter = FramePainter(Stage(scene, tracks, 'line', 600), scene, tracks)
        shut, opened, later = ((painter.draw(time) == (224, 123, 0)).all(axis=2).sum() for time in (0.9, 1.5, 2.1))
        assert opened < 0.7 * shut
        assert later == shut

    def test_dots_per_inch(self, runner):
        """Line widths are given in points of 1/72 inch."""
        assert self.painter(runner)[1].figure.dpi == DPI


class Encoder:
    """Stands for ffmpeg. Notes how many frames were drawn whenever one is written."""
    returncode = 0

    def __init__(self, drawn):
        self.drawn, self.noted, self.stdin = drawn, [], self

    def write(self, _):
        self.noted.append(len(self.drawn))

    def communicate(self):
        return b'', b''


class VideoTest:
    """MP4."""

    def test_frames_are_not_collected(self, monkeypatch):
        """Each frame is written before the next one is drawn: those of a long film do not fit in memory."""
        drawn = []
        encoder = Encoder(drawn)

        def frames():
            for number in range(50):
                drawn.append(number)
                yield numpy.full((2, 4, 3), number, dtype=numpy.uint8)
        monkeypatch.setattr('crowd_film.pictures.need_ffmpeg', lambda: 'ffmpeg')
        monkeypatch.setattr('crowd_film.pictures.subprocess.Popen', lambda *_, **__: encoder)
        write_mp4('film.mp4', frames(), None, 50)
        assert encoder.noted == list(range(1, 51))


class TimeTest:
    """Which times are shown."""

    def test_times(self):
        tracks = {0: track_of([(0, 0, 0), (40, 4, 0)], 0.1)}
        settings = Settings(pathlib.Path('film.webp'), '', start=1, duration=2, speed=2, fps=10)
        assert frame_times(settings, tracks) == pytest.approx([1 + 0.2 * i for i in range(11)])

    def test_frames_of_a_gif_last_hundredths_of_a_second(self):
        """15 frames a second are shown for 70 ms each, and so far apart that the speed is as given."""
        tracks = {0: track_of([(0, 0, 0), (40, 4, 0)], 0.1)}
        times = frame_times(Settings(pathlib.Path('film.gif'), '', speed=2, fps=15), tracks)
        assert times[1] == pytest.approx(0.14)
        assert times[-1] <= 4 < times[-1] + 0.14
