"""The site is built without warnings, and its links lead somewhere."""
import html.parser
import os
import pathlib
import subprocess
import urllib.parse

import pytest
from programs import in_package, tools_folder


class Page(html.parser.HTMLParser):
    """The links and anchors of a page."""

    def __init__(self, file):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(file.read_text(encoding='utf-8'))

    def handle_starttag(self, tag, attrs):
        """Called for each tag."""
        attributes = dict(attrs)
        self.anchors.update(attributes[name] for name in ('id', 'name') if attributes.get(name))
        self.links += [attributes[name] for name in ('href', 'src') if attributes.get(name)]


def build_with_a_page(folder):
    """Returns a build folder in which `scripts/web build` seems to have been run."""
    page = folder / 'web/page'
    page.mkdir(parents=True)
    for name in ('index.html', 'social_crowd.js'):
        (page / name).touch()
    (folder / 'devel').symlink_to(tools_folder().partition('/devel/')[0] + '/devel')
    return folder


def test_site(tmp_path_factory):
    """Guide, API, gallery and the page to try it are there; links within the site are those of files and sections."""
    for module in ('social_crowd._core', 'breathe', 'furo', 'myst_parser', 'sphinx_copybutton'):
        pytest.importorskip(module)  # of `scripts/install_dependencies site`
    site = tmp_path_factory.mktemp('site')
    environment = {**os.environ, 'SOCIAL_CROWD_BUILD': build_with_a_page(tmp_path_factory.mktemp('build'))}
    done = subprocess.run([in_package('scripts/site'), '--output', site], env=environment, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding='utf-8')
    assert done.returncode == 0, done.stdout
    pages = {file: Page(file) for file in site.rglob('*.html')}
    assert {'index.html', 'gallery.html', 'cpp.html', 'python.html', 'robots.html'} <= {file.name for file in pages}
    for name, declared in (('cpp', 'Episode'), ('python', 'VecEnv'), ('gallery', 'film_station'),
                           ('gallery', 'browser/index.html')):
        assert declared in (site / f'docs/site/{name}.html').read_text(encoding='utf-8')
    broken = []
    for file, page in pages.items():
        for link in page.links:
            path, _, anchor = urllib.parse.unquote(link.partition('?')[0]).partition('#')
            target = pathlib.Path(os.path.normpath(file.parent / path)) if path else file
            if '://' in link or link.startswith(('data:', 'mailto:')):
                continue
            if not target.exists() or (anchor and target in pages and anchor not in pages[target].anchors):
                broken.append(f'{file.relative_to(site)}: {link}')
    assert not broken
