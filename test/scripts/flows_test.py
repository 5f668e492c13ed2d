"""research/flows: measures of walks made by hand, bands, the table `human`, and runs of evaluate."""
import dataclasses
import pathlib
import re

import numpy
import pytest
import yaml
from crowd_flows import door_flow, fundamental_diagram, fundamental_diagram as corridors, measurements
from crowd_flows.measurements import evaluate, read_tracks
from crowd_tables.gait import without_gait
from programs import ANTICIPATION_TABLE, in_package, tools_folder

ANTICIPATION = pathlib.Path(ANTICIPATION_TABLE)
HUMAN = pathlib.Path(in_package('config', 'q_tables', 'human.txt'))
TICKS = 201


class MeasurementsTest:
    """Bands and ranges of measurements."""

    def test_a_band_holds_the_middle_of_the_measurements(self):
        measured = numpy.array([(0.1, 1.0)] * 4 + [(0.3, 0.1 * i) for i in range(11)])
        few, band = measurements.bands(measured, numpy.array([0.0, 0.25, 0.5]))
        assert few is None
        assert (band.low, band.median, band.high, band.count) == pytest.approx((0.1, 0.5, 0.9, 11))
        assert band.contains(0.1) and band.contains(0.9)
        assert not band.contains(0.08) and not band.contains(0.92)

    def test_weidmann_stops_at_his_highest_density(self):
        assert measurements.weidmann(5.4) == pytest.approx(0.0)
        assert measurements.weidmann(1.0) == pytest.approx(1.058, abs=0.001)

    def test_a_door_is_compared_with_doors_about_as_wide(self):
        measured = numpy.array([(1.0, 1.8), (1.0, 2.4), (1.05, 2.1), (1.5, 9.0)])
        assert measurements.door_range(measured, 1.0) == pytest.approx((1.8, 2.4))
        assert measurements.door_range(measured, 2.0) is None


class FundamentalDiagramTest:
    """Density and speed of walks made by hand."""

    def test_people_in_the_area_count_with_their_speed_ahead(self):
        corridor = dataclasses.replace(corridors.TWO_WAY, length=20.0)
        time = 0.1 * numpy.arange(TICKS)
        track = numpy.zeros((TICKS, 3, 2))
        track[:, 0, 0] = 8.5 + 0.1 * time  # in the area, from 8 to 12 m, all the time
        track[:, 1, 0] = 11.5 - 0.05 * time  # the same, in the other direction
        track[:, 2, 0] = 30.0 + time  # outside
        values = fundamental_diagram.measure(corridor, track)
        assert len(values) == 12  # seconds
        assert values == pytest.approx(numpy.array([[2.0 / (4.0 * 3.6), 0.075]] * 12))

    def test_single_file_is_counted_per_metre(self):
        corridor = dataclasses.replace(corridors.SINGLE_FILE, length=20.0)
        track = numpy.zeros((TICKS, 1, 2))
        track[:, 0, 0] = 9.0 + 0.01 * numpy.arange(TICKS)
        assert fundamental_diagram.measure(corridor, track) == pytest.approx(numpy.array([[0.25, 0.1]] * 12))

    @pytest.mark.parametrize('corridor', corridors.CORRIDORS, ids=lambda corridor: corridor.name)
    def test_corridors_are_filled_at_their_density_without_overlaps(self, corridor):
        for density in (corridor.densities[0], corridor.densities[-1]):
            scenario = yaml.safe_load(corridors.document(corridor, density, 1))
            places = numpy.array([agent['position'] for agent in scenario['agents']])
            assert len(places) == pytest.approx(corridor.per_length(density) * corridor.length, rel=0.03)
            assert (numpy.abs(places[:, 1]) <= corridor.width / 2.0 - corridors.RADIUS).all()
            distances = numpy.hypot(*(places[:, None] - places[None]).transpose(2, 0, 1))
            assert distances[~numpy.eye(len(places), dtype=bool)].min() > 2.0 * corridors.RADIUS
            ahead = {numpy.sign(agent['goal'][0] - agent['position'][0]) for agent in scenario['agents']}
            assert ahead == ({1.0} if corridor.direction == 'one_way' else {1.0, -1.0})


class DoorFlowTest:
    """Flow through a door of walks made by hand."""

    def test_counts_from_the_first_to_the_last(self):
        track = numpy.full((TICKS, 4, 2), -1.0)
        for agent, tick in enumerate((10, 40, 110)):  # the last agent stays
            track[tick:, agent, 0] = 0.5
        assert door_flow.flow_of(track) == pytest.approx((2 / 10.0, 3))

    def test_no_people_are_no_flow(self):
        assert door_flow.flow_of(numpy.full((TICKS, 4, 2), -1.0)) == (0.0, 0)


class HumanTest:
    """What the shipped table has learned."""

    def test_the_page_names_its_body(self):
        header = HUMAN.read_text(encoding='utf-8').split('\n---\n')[0]
        page = pathlib.Path(in_package('docs', 'human.md')).read_text(encoding='utf-8')
        for key in ('motion', 'gait'):
            assert re.search(key + r': \{[^}]*\}', header)[0] in page

    def test_people_without_company_walk_straight(self, tmp_path):
        table, scenario = tmp_path / 'table.txt', tmp_path / 'alone.yaml'
        table.write_bytes(without_gait(HUMAN.read_bytes()))
        agent = '{position: [0, 0], goal: [12, 0], speed: 1.3, radius: 0.2}'
        scenario.write_text(f'{{name: alone, duration: 20, goal_tolerance: 0.3, agents: [{agent}]}}', encoding='utf-8')
        metrics = evaluate(pathlib.Path(tools_folder()) / 'evaluate', table, scenario, tmp_path)
        assert float(metrics['success_pct']) == 100.0
        assert float(metrics['turn_rad_per_m']) == pytest.approx(0.0, abs=0.01)

    def test_tables_without_a_gait_are_refused(self):
        contents = HUMAN.read_bytes()
        for wrong in (b'', contents[:-1000], contents.replace(b'seed: 1', b'seed: 2')):
            with pytest.raises(ValueError, match='valid checksum'):
                without_gait(wrong)
        with pytest.raises(ValueError, match='with a gait'):
            without_gait(ANTICIPATION.read_bytes())


def test_a_dense_human_crowd_is_slow_and_without_contacts(tmp_path):
    corridor = dataclasses.replace(corridors.ONE_WAY, length=30.0, begin=4.0, end=6.0)
    scenario = tmp_path / 'corridor.yaml'
    scenario.write_text(corridors.document(corridor, 2.5, 1), encoding='utf-8')
    speeds = {}
    for table in (ANTICIPATION, HUMAN):
        metrics = evaluate(pathlib.Path(tools_folder()) / 'evaluate', table, scenario, tmp_path)
        assert float(metrics['contact_pct']) == 0.0
        values = fundamental_diagram.measure(corridor, read_tracks(tmp_path / 'corridor.csv')[0])
        speeds[table.stem] = values[:, 1].mean()
    assert 0.2 < speeds['human'] < 0.6
    assert speeds['anticipation'] > 0.9
