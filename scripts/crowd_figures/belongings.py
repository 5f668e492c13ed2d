"""What people have with them: a wheelchair, a suitcase on wheels, a stick."""
from .shapes import box, join, limb, wheel


def wheelchair():
    """Two large wheels, two small ones, seat, back, foot rest and handles."""
    parts = [box((-0.2, -0.23, 0.4), (0.25, 0.23, 0.44)), box((-0.24, -0.23, 0.4), (-0.2, 0.23, 0.9)),
             box((0.42, -0.2, 0.06), (0.68, 0.2, 0.08))]
    for side in (1, -1):
        parts += [wheel((-0.08, side * 0.28, 0.31), 0.31, 0.05, 12), wheel((0.36, side * 0.2, 0.09), 0.09, 0.04, 8),
                  limb([(-0.2, side * 0.22, 0.88), (-0.38, side * 0.22, 0.9)], (0.02, 0.02), 4),
                  limb([(0.25, side * 0.18, 0.42), (0.5, side * 0.18, 0.07)], (0.02, 0.02), 4)]
    return join(*parts)


def trolley():
    """A suitcase behind the right hand, its handle and two wheels."""
    return join(box((-0.52, -0.42, 0.08), (-0.24, -0.02, 0.72)),
                limb([(-0.3, -0.22, 0.7), (-0.1, -0.22, 0.84)], (0.018, 0.018), 4),
                *(wheel((-0.46, -0.22 + side * 0.17, 0.06), 0.06, 0.04, 8) for side in (1, -1)))


def stick():
    """A walking stick in the right hand."""
    return limb([(0.22, -0.23, 0.96), (0.28, -0.23, 0.0)], (0.028, 0.022), 4)


def stick_in_hand():
    """A walking stick below a hand at the origin."""
    return limb([(0.02, 0.0, -0.07), (0.02, 0.0, -0.86)], (0.028, 0.022), 4)


def shapes():
    """All of them, by the name of their file."""
    return {'wheelchair': wheelchair(), 'trolley': trolley(), 'stick': stick()}
