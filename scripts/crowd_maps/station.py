"""A station hall of 50 x 30 m: entrances in the south, a row of ticket gates, and four platforms in the north."""
from crowd_maps.floor import Floor

GATES = 10
FIRST_GATE, GATE_PITCH, GATE_BLOCK = 12.0, 2.5, 1.5  # [m] 1 m between the blocks
BARRIER = (15.0, 16.6)
PLATFORMS = [5.0, 17.0, 29.0, 41.0]  # left sides of the exits to the platforms, 4 m wide
COLUMN = 0.8  # side [m]


def draw():
    """Returns the floor."""
    floor = Floor(50, 30)
    bottom, top = BARRIER
    middle = (bottom + top) / 2
    floor.block(0, middle - 0.1, FIRST_GATE, middle + 0.1)
    last = FIRST_GATE + GATES * GATE_PITCH
    for i in range(GATES + 1):
        left = FIRST_GATE + i * GATE_PITCH
        floor.block(left, bottom, left + GATE_BLOCK, top)
    floor.block(last + GATE_BLOCK, middle - 0.1, 50, middle + 0.1)
    floor.block(0, 26, 50, 30)  # the north wall, with the exits to the platforms
    for left in PLATFORMS:
        floor.opening(left, 26, left + 4, 30)
    for x in (8.0, 18.0, 31.2, 41.2):
        for y in (6.0, 20.6):
            floor.block(x, y, x + COLUMN, y + COLUMN)
    floor.block(22.5, 5.0, 27.5, 8.0)  # information
    floor.block(0, 9.0, 3.0, 13.0)  # shops along the walls
    floor.block(47.0, 9.0, 50, 13.0)
    floor.block(12.0, 0, 14.0, 0.6)  # ticket machines
    floor.block(36.0, 0, 38.0, 0.6)
    return floor
