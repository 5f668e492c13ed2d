"""A supermarket of 30 x 20 m: shelves with a cross aisle, and six tills in front of the exit."""
from crowd_maps.floor import Floor

SHELVES = 9
FIRST_SHELF, PITCH, SHELF = 3.0, 2.8, 0.9  # [m] 1.9 m between shelves
TILLS = 6
FIRST_TILL, TILL_PITCH, TILL = 10.0, 2.4, 1.0  # [m] 1.4 m between tills
FRONT = 5.0  # of the wall between entrance and exit


def draw():
    """Returns the floor."""
    floor = Floor(30, 20)
    for i in range(SHELVES):
        left = FIRST_SHELF + i * PITCH
        floor.block(left, 10.5, left + SHELF, 13.4)
        floor.block(left, 15.0, left + SHELF, 18.2)
    floor.block(0, 14.0, 0.6, 18.2)  # shelves along the walls
    floor.block(29.4, 8.0, 30, 18.2)
    floor.block(4.0, 7.0, 5.6, 8.0)  # vegetables, on two tables near the entrance
    floor.block(7.0, 7.0, 8.6, 8.0)
    last = FIRST_TILL + TILLS * TILL_PITCH
    for i in range(TILLS + 1):
        left = FIRST_TILL + i * TILL_PITCH
        floor.block(left, 4.0, left + TILL, 6.2)
    floor.block(8.0, 0, 8.2, FRONT)  # walls between entrance, tills and exit
    floor.block(8.0, FRONT, FIRST_TILL, FRONT + 0.2)
    floor.block(last + TILL, FRONT, 30, FRONT + 0.2)
    floor.block(4.0, 1.0, 4.4, 5.0)  # a rail that leads people in
    return floor
