"""Chapters of which the texts are in a YAML file."""
import pathlib
import re

import yaml
from crowd_experiments import style
from crowd_experiments.pages import Chapter

COUNT = re.compile(r'\{([\d,]+)\|([\d,]+)\}')  # a number, and the one with --quick


def read_texts(package):
    """Returns the texts of a package, given its __file__, by chapters."""
    return yaml.safe_load(pathlib.Path(package).with_name('texts.yaml').read_text(encoding='utf-8'))


class Report(Chapter):
    """A chapter with a setting. Its texts have names: `title`, and those of texts, figures and tables. In a text,
    {name} stands for a value, and {100|5} for 100, with --quick for 5."""

    def __init__(self, name, texts, setting, **values):
        super().__init__(name, texts[name]['title'])
        self.texts, self.setting, self.values = texts[name], setting, values

    def text_of(self, name, **values):
        text = COUNT.sub(lambda match: str(self.setting.count(*match.groups())), self.texts[name])
        return text.format(**{**self.values, **values})

    def say(self, name, **values):
        self.add_text(self.text_of(name, **values))

    def draw(self, figure, file, text=None, **values):
        """Saves a figure and adds it; its caption has the name of the file, unless another name is given."""
        self.add_figure(style.save(figure, self.setting.figure_file(file)), self.text_of(text or file, **values))

    def tabulate(self, name, header, rows, text=None, **values):
        """Adds a table; its title has the name of the table, unless another name is given."""
        self.add_table(self.text_of(text or name, **values), header, rows, name)
