"""Messages and services in the form of ROS 2 that docs/ros2.md makes of them: the parser of ROS 2 reads them."""
import pathlib
import re
import shutil
import subprocess

import pytest
import yaml
from programs import in_package, page_text, read_text

parser = pytest.importorskip('rosidl_adapter.parser')  # in Debian: python3-rosidl
NAME = 'social_crowd_msgs'


@pytest.fixture(scope='module')
def package(tmp_path_factory):
    """A folder with msg/ and srv/, changed by the lines of the page."""
    folder = tmp_path_factory.mktemp(NAME)
    for kind in ('msg', 'srv'):
        shutil.copytree(in_package(kind), folder / kind)
    lines = re.findall(r'^    (sed .*)$', page_text('ros2.md'), re.MULTILINE)
    assert len(lines) == 2
    for line in lines:
        subprocess.run(line, shell=True, check=True, cwd=folder)
    return folder


def test_all_are_read(package):
    for kind, parse in (('msg', parser.parse_message_string), ('srv', parser.parse_service_string)):
        files = sorted((package / kind).iterdir())
        assert len(files) > 10
        for file in files:
            text = read_text(file)
            parse(NAME, file.stem, text)
            assert 'social_crowd/' not in text, file


def test_the_rules_name_the_fields_of_both(package):
    for rule in yaml.safe_load(pathlib.Path(in_package('config', 'ros1_bridge.yaml')).read_text(encoding='utf-8')):
        name = rule.get('ros1_message_name')
        if name is None:
            continue
        theirs = parser.parse_message_string(NAME, name, read_text(package / 'msg' / f'{name}.msg'))
        ours = re.findall(r'^[\w/\[\]]+ +(\w+)', read_text(in_package('msg', f'{name}.msg')), re.MULTILINE)
        fields = rule.get('fields_1_to_2', {})
        assert set(fields) <= set(ours) and set(fields.values()) <= {field.name for field in theirs.fields}
