"""Maps in the format of map_server, for drawings."""
import math
import pathlib

import yaml
from matplotlib.transforms import Affine2D

from crowd_drawing.errors import InputError

OCCUPIED_COLOUR = (70, 74, 82)
UNKNOWN_COLOUR = (224, 226, 230)
FREE_COLOUR = (255, 255, 255)


class MapPicture:
    """The pixels of a map in three colours, uppermost row first, with its resolution [m] and origin [x, y, yaw]."""

    def __init__(self, pixels, resolution, origin):
        self.pixels = pixels
        self.resolution = resolution
        self.origin = origin
        self.size = [side * resolution for side in (pixels.shape[1], pixels.shape[0])]  # width, height [m]

    def transform(self):
        """Returns the transformation from metres in the map to metres in the scene."""
        return Affine2D().rotate(self.origin[2]).translate(*self.origin[:2])

    def corners(self):
        return [tuple(self.transform().transform((x, y))) for x in (0, self.size[0]) for y in (0, self.size[1])]


def read_map(file):
    """Returns the MapPicture of a YAML file of map_server. Raises InputError if it cannot be drawn."""
    try:
        keys = yaml.safe_load(pathlib.Path(file).read_text(encoding='utf-8'))
        resolution, origin = float(keys['resolution']), [float(number) for number in keys['origin']]
        thresholds = float(keys['free_thresh']), float(keys['occupied_thresh'])
        image, negate = pathlib.Path(file).parent / keys['image'], str(keys['negate']) in ('1', 'True')
    except (yaml.YAMLError, KeyError, TypeError, ValueError) as error:
        raise InputError(f"{file}: is not a map of map_server: {' '.join(str(error).split())}") from None
    if not (len(origin) == 3 and all(map(math.isfinite, origin)) and 0 < resolution < math.inf):
        raise InputError(f'{file}: expected a resolution above 0 and an origin [x, y, yaw]')
    return MapPicture(colours_of(image, negate, *thresholds), resolution, origin)


def colours_of(image, negate, free_threshold, occupied_threshold):
    """Returns the pixels of an image in the colours of free, occupied and unknown cells."""
    import numpy  # these two are needed for maps only
    import PIL.Image
    try:
        with PIL.Image.open(image) as opened:
            grey = numpy.asarray(opened.convert('L'), dtype=float)
    except PIL.UnidentifiedImageError:
        raise InputError(f'{image}: is not an image') from None
    darkness = (grey if negate else 255.0 - grey) / 255.0
    pixels = numpy.full(grey.shape + (3,), UNKNOWN_COLOUR, dtype=numpy.uint8)
    pixels[darkness < free_threshold] = FREE_COLOUR
    pixels[darkness > occupied_threshold] = OCCUPIED_COLOUR
    return pixels
