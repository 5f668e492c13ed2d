"""Elements of an XML file with their lines."""
import math
import xml.parsers.expat

from crowd_drawing.errors import InputError


class Element:
    """An XML element: its tag, its attributes, and the file and line where it starts, for messages."""

    def __init__(self, file, line, tag, attributes):
        self.file = file
        self.line = line
        self.tag = tag
        self.attributes = attributes
        self.children = []

    def fail(self, text):
        """Raises InputError with file, line and tag of the element."""
        raise InputError(f'{self.file}:{self.line}: {self.tag}: {text}')

    def text(self, name):
        """Returns an attribute, which must be present and not empty."""
        value = self.attributes.get(name, '')
        if not value:
            self.fail(f"the attribute '{name}' is missing")
        return value

    def number(self, name, default=None):
        """Returns an attribute as a finite number. It must be present unless there is a default."""
        if default is not None and name not in self.attributes:
            return default
        text = self.text(name)
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            self.fail(f"{name}: expected a number, got '{text}'")
        return value

    def not_negative(self, name, default=None):
        """Returns an attribute as a finite number of 0 or more."""
        value = self.number(name, default)
        if value < 0:
            self.fail(f"{name}: expected a number of 0 or more, got '{self.attributes[name]}'")
        return value

    def whole(self, name, default=None):
        """Returns an attribute as a whole number of 0 or more."""
        value = self.not_negative(name, default)
        if value != int(value):
            self.fail(f"{name}: expected a whole number, got '{self.attributes[name]}'")
        return int(value)


def read_root(file):
    """Returns the root element of an XML file. Raises InputError with the line of an error."""
    with open(file, 'rb') as stream:
        data = stream.read()
    parser = xml.parsers.expat.ParserCreate()
    document = Element(file, 0, 'document', {})
    path = [document]

    def start(tag, attributes):
        path[-1].children.append(Element(file, parser.CurrentLineNumber, tag, attributes))
        path.append(path[-1].children[-1])

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda _tag: path.pop()
    try:
        parser.Parse(data, True)
    except (xml.parsers.expat.ExpatError, ValueError) as error:  # ValueError: an encoding that is not supported
        reason = getattr(error, 'code', None)
        message = str(error) if reason is None else xml.parsers.expat.ErrorString(reason)
        raise InputError(f'{file}:{parser.CurrentLineNumber}: not XML: {message}') from None
    return document.children[0]
