"""An office floor of 40 x 25 m: two rows of rooms, two corridors, a core with meeting room and kitchen, a reception."""
from crowd_maps.floor import Floor

WALL = 0.15  # thickness of inner walls [m]
SOUTH, NORTH = 7.0, 18.0  # inner borders of the rows of rooms
CORE = (9.5, 15.5)  # lower and upper border of the core between the corridors
SIDES = [0, 7, 13, 19, 26, 33, 40]  # borders of the rooms in a row
CORE_SIDES = [8, 17, 23.5, 27.5, 32, 37.5]  # meeting room, kitchen, copies, archive, quiet room


def draw_row(floor, border, sign):
    """Draws a row of six rooms; `sign` is the direction of the corridor from the border: 1 up, -1 down."""
    low, high = sorted((border, border + sign * WALL))
    floor.block(0, low, 40, high)
    outer = 0 if sign > 0 else 25
    for i, (left, right) in enumerate(zip(SIDES, SIDES[1:])):
        bottom, top = sorted((outer, border))
        if i > 0:
            floor.block(left, bottom, left + WALL, top)
        door = left + 1.2 if i % 2 == 0 else right - 1.9
        floor.opening(door, low, door + (1.0 if i % 2 == 0 else 0.9), high)
        draw_desks(floor, left, right, outer, sign)


def draw_desks(floor, left, right, outer, sign):
    """Draws two double desks in the outer half of a room, a passage between them, and a cupboard."""
    middle = (left + right) / 2
    for desk in (middle - 2.0, middle + 0.6):
        bottom, top = sorted((outer + sign * 1.5, outer + sign * 3.1))
        floor.block(desk, bottom, desk + 1.4, top)
    bottom, top = sorted((outer, outer + sign * 0.4))
    floor.block(middle - 0.8, bottom, middle + 0.8, top)


def draw_core(floor):
    """Draws the rooms between the corridors with their doors and furniture."""
    bottom, top = CORE
    floor.block(CORE_SIDES[0], bottom, CORE_SIDES[-1] + WALL, top)
    for left, right in zip(CORE_SIDES, CORE_SIDES[1:]):
        floor.opening(left + WALL, bottom + WALL, right, top - WALL)
    for left in (9.0, 21.5, 24.5, 35.0):  # doors to the lower corridor
        floor.opening(left, bottom, left + 1.0, bottom + WALL)
    for left in (15.0, 18.0, 28.5):  # doors to the upper corridor
        floor.opening(left, top - WALL, left + 1.0, top)
    floor.block(10.5, 11.8, 15.5, 13.2)  # table of the meeting room
    floor.block(17.15, 12.0, 17.75, 14.0)  # kitchen: counter and two tables
    floor.block(19.5, 11.5, 20.5, 12.5)
    floor.block(21.5, 13.0, 22.5, 14.0)
    floor.block(25.9, 14.0, 27.5, 14.6)  # copier
    for left in (28.5, 30.2):  # shelves of the archive
        floor.block(left, 11.0, left + 0.5, 13.6)
    floor.block(33.5, 12.0, 34.5, 13.0)  # quiet room


def draw_reception(floor):
    """Draws the desk of the reception, an L, and seats in the west of the hall between the rows of rooms."""
    floor.block(3.5, 11.0, 4.1, 14.0)
    floor.block(4.1, 13.4, 5.4, 14.0)
    floor.block(0, 8.5, 0.6, 10.5)
    floor.block(0, 15.0, 0.6, 16.8)


def draw():
    """Returns the floor."""
    floor = Floor(40, 25)
    draw_row(floor, SOUTH - WALL, 1)
    draw_row(floor, NORTH + WALL, -1)
    draw_core(floor)
    draw_reception(floor)
    return floor
