"""Makes a wheel of the Python package without ROS, for pip (PEP 517). It needs CMake, a compiler, and the libraries of
src/core.cmake, but no other Python package.
"""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
NAME = 'social_crowd'
DATA = ('config/kinds.yaml', 'config/learning', 'config/maps', 'config/q_tables', 'config/recordings',
        'config/scenarios')
DATE = (1980, 1, 1, 0, 0, 0)  # of all files, so that the same sources give the same wheel
METADATA = """Metadata-Version: 2.1
Name: {name}
Version: {version}
Summary: Simulates crowds that learn to walk, and robots among them
License: BSD-3-Clause
Requires-Python: >=3.8
Description-Content-Type: text/plain

Simulates crowds that learn to walk, and robots among them. It needs NumPy.
"""
WHEEL = """Wheel-Version: 1.0
Generator: {name}
Root-Is-Purelib: false
Tag: {tag}
"""


def build_wheel(wheel_directory, _config_settings=None, _metadata_directory=None):
    """Builds the C++ module, and writes the wheel. Returns its file name."""
    version, tag = version_of_package(), tag_of_python()
    info = f'{NAME}-{version}.dist-info'
    files = {f'{NAME}/{module.name}': module.read_bytes() for module in build_module()}
    for source in sorted((REPOSITORY / 'python' / NAME).glob('*.py')):
        files[f'{NAME}/{source.name}'] = source.read_bytes()
    for data in DATA:
        path = REPOSITORY / data
        for file in sorted(path.rglob('*')) if path.is_dir() else [path]:
            if file.is_file():
                files[f'{NAME}/{file.relative_to(REPOSITORY)}'] = file.read_bytes()
    files.update((f'{info}/{name}', content) for name, content in metadata().items())
    record = ''.join(f'{name},sha256={digest(content)},{len(content)}\n' for name, content in files.items())
    files[f'{info}/RECORD'] = f'{record}{info}/RECORD,,\n'.encode()
    wheel = f'{NAME}-{version}-{tag}.whl'
    with zipfile.ZipFile(os.path.join(wheel_directory, wheel), 'w', zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name, DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content)
    return wheel


def prepare_metadata_for_build_wheel(metadata_directory, _config_settings=None):
    """Writes the metadata of the wheel, so that nothing is built to read them. Returns the name of their folder."""
    info = pathlib.Path(metadata_directory, f'{NAME}-{version_of_package()}.dist-info')
    info.mkdir()
    for name, content in metadata().items():
        (info / name).write_bytes(content)
    return info.name


def build_sdist(_sdist_directory, _config_settings=None):
    """Not supported: the sources are those of the repository."""
    raise NotImplementedError('there is no source distribution: use the repository')


def get_requires_for_build_wheel(_config_settings=None):
    """Returns the Python packages that a build needs: none."""
    return []


def metadata():
    """Returns the files of the folder .dist-info but RECORD, by name."""
    return {
        'LICENSE': (REPOSITORY / 'LICENSE').read_bytes(),
        'METADATA': METADATA.format(name=NAME, version=version_of_package()).encode(),
        'WHEEL': WHEEL.format(name=NAME, tag=tag_of_python()).encode(),
    }


def build_module():
    """Builds the C++ module. Returns its files."""
    build = pathlib.Path(os.environ.get('SOCIAL_CROWD_BUILD', REPOSITORY / '.build')) / 'wheel'
    output = build / 'installed'
    run('cmake', '-S', REPOSITORY / 'python' / 'wheel', '-B', build, f'-DPYTHON_EXECUTABLE={sys.executable}',
        '-DCMAKE_BUILD_TYPE=Release', '-DBUILD_SHARED_LIBS=OFF', f'-DCMAKE_INSTALL_PREFIX={output}')
    run('cmake', '--build', build, '--parallel', len(os.sched_getaffinity(0)))
    for old in output.glob('*'):
        old.unlink()
    run('cmake', '--install', build, '--strip')
    return sorted(output.glob('*.so'))


def run(*command):
    """Runs a command, which must succeed."""
    subprocess.run(list(map(str, command)), check=True)


def version_of_package():
    """Returns the version in package.xml."""
    return re.search('<version>(.*)</version>', (REPOSITORY / 'package.xml').read_text(encoding='utf-8')).group(1)


def tag_of_python():
    """Returns the tag of this Python and this kind of machine."""
    python = f'cp{sys.version_info.major}{sys.version_info.minor}'
    return f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def digest(content):
    """Returns the checksum of a file as RECORD has it."""
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b'=').decode()
