"""All files name the same version, and say what is needed to find and to cite the package."""
import re
import xml.etree.ElementTree as ElementTree

import yaml
from catkin_pkg.changelog import get_changelog_from_path
from programs import in_package, read_text

PACKAGE = ElementTree.parse(in_package('package.xml'))


def load(name):
    """Returns the content of a YAML file."""
    return yaml.safe_load(read_text(in_package(name)))


def test_versions():
    """The last release of the changelog, or the one before what is forthcoming, is the version of the package."""
    version = PACKAGE.findtext('version')
    changelog = get_changelog_from_path(in_package('CHANGELOG.rst'), 'social_crowd')
    released = [(number, date) for number, date, _ in changelog.foreach_version() if number != 'Forthcoming']
    citation = load('CITATION.cff')
    assert released[0][0] == version == citation['version']
    assert released[0][1].strftime('%Y-%m-%d') == citation['date-released']


def test_citation():
    """It has the keys that the format requires."""
    citation = load('CITATION.cff')
    assert {'cff-version', 'message', 'title', 'authors'} <= set(citation)
    assert citation['license'] == PACKAGE.findtext('license')


def test_scripts_of_workflows():
    """Workflows, hooks and the Dockerfile run scripts that exist, with purposes and checks that these know."""
    names = ('.github/workflows/ci.yml', '.github/workflows/industrial_ci.yml', '.github/workflows/release.yml',
             '.pre-commit-config.yaml', 'Dockerfile', 'CONTRIBUTING.md')
    texts = {name: read_text(in_package(name)) for name in names}
    for name, text in texts.items():
        for script in re.findall(r'\bscripts/(\w+)\b(?!\.py)', text):
            assert read_text(in_package('scripts', script)), f'{name}: {script}'
    lint = read_text(in_package('scripts/lint')).partition('checks=(')[2].partition(')')[0].split()
    hook = next(hook for hook in load('.pre-commit-config.yaml')['repos'][0]['hooks'] if hook['id'] == 'lint')
    assert set(hook['entry'].split()[1:]) <= set(lint)
