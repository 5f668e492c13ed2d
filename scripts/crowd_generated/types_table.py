"""The table of state sets, action sets and rewards in docs/state_sets.md, as train prints it."""
import re
import subprocess

from crowd_experiments.tools import find_tools

TABLE = re.compile(r'(<!-- types -->\n).*?(?=<!-- end -->)', re.DOTALL)


def written(package, tools):
    """Returns {file: text} of the page. tools: folder of train, or None."""
    page = package / 'docs' / 'state_sets.md'
    table = subprocess.run([find_tools(tools) / 'train', '--list-types'], stdout=subprocess.PIPE, text=True,
                           check=True).stdout
    return {page: TABLE.sub(lambda found: found[1] + table, page.read_text(encoding='utf-8'))}
