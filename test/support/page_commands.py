"""Command lines on a page in Markdown."""
import re

PROGRAMS = ('chmod', 'cmake', 'export', 'rosbag', 'roslaunch', 'rosmsg', 'rosnode', 'rosparam', 'rosrun', 'rosservice',
            'rossrv', 'rostopic', 'source')
FENCED = re.compile(r'^```\w*\n(.*?)^```$', re.DOTALL | re.MULTILINE)
INLINE = re.compile(r'(?<!`)`([^`\n]+)`(?!`)')


def code_blocks(page):
    """Returns the blocks of code of a page, without their indentation."""
    blocks, lines = FENCED.findall(page), []
    for line in [*FENCED.sub('', page).splitlines(), 'end']:
        if line.startswith('    ') or (lines and not line.strip()):
            lines.append(line[4:])
        elif lines:
            blocks.append('\n'.join(lines).rstrip() + '\n')
            lines = []
    return blocks


def is_command(line):
    """Returns whether a line calls a program, with arguments unless it is a script."""
    word, _, arguments = line.partition(' ')
    folders = 'scripts/', 'research/', 'build/', './'
    return (word in PROGRAMS and arguments) or word == 'catkin_make' or word.startswith(folders)


def command_lines(page):
    """Returns the command lines in blocks of code, and in the text and tables of a page; each once."""
    in_blocks = [line for block in code_blocks(page) if is_command(block) for line in block.splitlines()]
    texts = '\n'.join(line for line in FENCED.sub('', page).splitlines() if not line.startswith('    '))
    in_text = [words for words in INLINE.findall(texts) if is_command(words)]
    return list(dict.fromkeys(line.partition('   #')[0].strip() for line in in_blocks + in_text if line.strip()))


def other_blocks(page):
    """Returns the blocks of code that are no command lines."""
    return [block for block in code_blocks(page) if not is_command(block)]
