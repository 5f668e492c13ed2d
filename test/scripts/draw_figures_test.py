"""scripts/draw_figures: the meshes of the package are those that it makes; bodies that stand on the floor."""
import subprocess
import sys
from pathlib import Path

import numpy
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / 'scripts'))
from crowd_figures import people  # noqa: E402
from crowd_figures.bodies import BUILDS, skeleton_of  # noqa: E402
from crowd_figures.shapes import box, ellipse, limb, loft, wheel  # noqa: E402
from crowd_figures.shapes import TRIANGLE  # noqa: E402


def volume(shape):
    """Volume of a closed shape [m^3]; negative if its corners are clockwise."""
    return float(numpy.einsum('ij,ij->i', shape[:, 0], numpy.cross(shape[:, 1], shape[:, 2])).sum() / 6)


def read(file):
    """Returns the triangles of a binary STL file."""
    content = file.read_bytes()
    rows = numpy.frombuffer(content[84:], TRIANGLE)
    assert len(rows) == int.from_bytes(content[80:84], 'little')
    return rows


@pytest.fixture(scope='module')
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp('figures') / 'meshes'
    command = [str(ROOT / 'scripts' / 'draw_figures'), '--output', str(folder)]
    run = subprocess.run(command, stdout=subprocess.PIPE, check=False)
    assert run.returncode == 0
    assert b'44 meshes' in run.stdout
    return folder


def test_meshes_of_the_package_are_up_to_date_and_small(made):
    shipped = sorted((ROOT / 'meshes').iterdir())
    assert [file.name for file in shipped] == sorted(file.name for file in made.iterdir())
    for file in shipped:
        assert numpy.allclose(read(file)['corners'], read(made / file.name)['corners'], atol=1e-5), file.name
    assert sum(file.stat().st_size for file in shipped) < 600_000


def test_lower_foot_is_on_the_floor(made):
    for file in made.glob('*_dark_*.stl'):
        assert abs(read(file)['corners'][:, :, 2].min()) < 1e-6, file.name


def test_people_are_as_tall_and_wide_as_people(made):
    for build in 'broad', 'slim':
        corners = numpy.concatenate([read(file)['corners'] for file in made.glob(f'{build}_*.stl')])
        assert 1.7 < corners[:, :, 2].max() < 1.8
        assert 0.4 < numpy.ptp(corners[:, :, 1]) < 0.6


def test_who_sits_fits_into_the_wheelchair_and_its_wheels_are_on_the_floor(made):
    chair, person = (read(made / f'{name}.stl')['corners'] for name in ('wheelchair', 'sitting_dark'))
    assert abs(chair[:, :, 2].min()) < 1e-6 and person[:, :, 2].min() > 0.04
    assert 0.5 < numpy.ptp(chair[:, :, 1]) < 0.7
    assert 1.2 < read(made / 'sitting_head.stl')['corners'][:, :, 2].max() < 1.45


def test_shapes_are_closed_with_the_outside_outwards():
    # A prism with a regular hexagon of radius 0.1 m and a length of 0.5 m.
    assert volume(limb([(0, 0, 0.5), (0, 0, 0)], (0.1, 0.1))) == pytest.approx(1.5 * 3 ** 0.5 * 0.01 * 0.5)
    assert volume(limb([(0, 0, 0), (0.5, 0, 0)], (0.1, 0.1))) == pytest.approx(1.5 * 3 ** 0.5 * 0.01 * 0.5)
    assert volume(loft([ellipse((0, 0, z), 0.1, 0.1, 4) for z in (0, 1)])) == pytest.approx(0.02)
    assert volume(box((1, 2, 3), (2, 4, 6))) == pytest.approx(6.0)
    assert volume(wheel((1, 2, 3), 0.1, 0.5, 4)) == pytest.approx(0.01)


def test_pictures_are_those_of_a_walk():
    """Half a cycle later, left and right have changed places; knees bend, arms swing against legs."""
    skeleton = skeleton_of(BUILDS['broad'])
    poses = people.poses(skeleton)
    assert len(poses) == people.FRAMES + 1

    def bend(frame, joint):
        return float(poses[frame][0][joint].as_rotvec()[0, 1])
    for frame in range(people.FRAMES):
        half = (frame + people.FRAMES // 2) % people.FRAMES
        for joint in ('thigh', 'shank', 'upper_arm', 'forearm'):
            assert bend(frame, f'left_{joint}') == pytest.approx(bend(half, f'right_{joint}'), abs=0.05)
        assert 0.1 < bend(frame, 'left_shank') < 1.2
        legs, arms = (bend(frame, f'left_{joint}') - bend(frame, f'right_{joint}') for joint in ('thigh', 'upper_arm'))
        assert legs * arms < 0 or abs(legs) < 0.3
    assert bend(people.FRAMES, 'left_shank') == pytest.approx(bend(people.FRAMES, 'right_shank'))
    assert max(bend(frame, 'left_shank') for frame in range(people.FRAMES)) > 0.7
