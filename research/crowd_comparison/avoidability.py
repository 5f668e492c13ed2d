"""Classifies contacts with moving obstacles, which do not yield, by whether a move could have avoided them.

A contact begins at a tick at the end of which an agent overlaps a moving obstacle by more than 1 mm, but not at the end
of the previous tick. It was avoidable if there is a straight move that begins at a tick within the last LOOK_BACK
seconds before the contact and lasts until LOOK_ON seconds after it, during which the agent does not overlap any body or
wall by more than 1 mm at the end of any tick. A straight move is to walk at one of HEADINGS headings at full or half
the maximum speed, or to stand. All other bodies move as recorded, including agents that gave way. The classification
uses hindsight: it does not consider what the agent could have predicted.
"""
import math
import typing

import numpy

from crowd_drawing.files import place_of

OVERLAP = 1e-3  # [m]
LOOK_BACK, LOOK_ON = 3.0, 1.0  # [s]
HEADINGS = 36
SHARES = (0.5, 1.0)  # of the maximum speed
TURNED_WITHIN = 1.0  # [s] before the contact; no agent can predict such a recent turn of the obstacle


class Contact(typing.NamedTuple):
    """An agent and a moving obstacle that begin to overlap at the end of a tick."""
    agent: int
    obstacle: int
    tick: int


class Escape(typing.NamedTuple):
    """A move that would have avoided a contact, beginning at the end of a tick."""
    tick: int
    velocity: tuple  # [m/s]


class Recording:
    """A scene with the recorded trajectories."""

    def __init__(self, scene, track):
        """@param scene with drawn values @param track places (tick, agent, 2) [m], nan after an agent has left"""
        self.scene = scene
        self.track = track
        self.radii = numpy.array([agent['radius'] for agent in scene.agents])
        ticks = len(track) + round(LOOK_ON / scene.tick)
        self.obstacles = numpy.array([[place_of(obstacle, tick * scene.tick) for obstacle in scene.obstacles]
                                      for tick in range(ticks)]).reshape(ticks, len(scene.obstacles), 2)
        self.obstacle_radii = numpy.array([obstacle['radius'] for obstacle in scene.obstacles])

    def contacts(self):
        found = []
        for obstacle in range(len(self.obstacle_radii)):
            if not numpy.ptp(self.obstacles[:, obstacle], axis=0).any():  # it does not move
                continue
            away = self.track - self.obstacles[:len(self.track), obstacle][:, None]
            overlap = numpy.hypot(away[..., 0], away[..., 1]) < self.radii + self.obstacle_radii[obstacle] - OVERLAP
            begins = overlap[1:] & ~overlap[:-1]  # nan overlaps nothing
            found += [Contact(int(agent), obstacle, int(tick) + 1) for tick, agent in zip(*numpy.nonzero(begins))]
        return sorted(found, key=lambda contact: (contact.tick, contact.agent))

    def last_escape(self, contact, among_others=True):
        """Returns the latest move that would have avoided a contact, maybe without the others; None without one."""
        ticks_back = min(contact.tick, round(LOOK_BACK / self.scene.tick))
        for tick in range(contact.tick - 1, contact.tick - ticks_back - 1, -1):
            velocities = self.straight_moves(contact.agent)
            clear = self.are_clear(contact, tick, velocities, among_others)
            if clear.any():
                return Escape(tick, tuple(velocities[numpy.argmax(clear)]))
        return None

    def straight_moves(self, agent):
        """Returns the velocities (n, 2) of standing, and of all headings and fractions of the maximum speed [m/s]."""
        angles = 2.0 * math.pi / HEADINGS * numpy.arange(HEADINGS)
        directions = numpy.stack([numpy.cos(angles), numpy.sin(angles)], axis=1)
        speed = self.scene.agents[agent]['speed']
        return numpy.concatenate([numpy.zeros((1, 2)), *(share * speed * directions for share in SHARES)])

    def are_clear(self, contact, begin, velocities, among_others):
        """Returns for each move that begins at a tick whether it is clear until LOOK_ON after the contact."""
        end = contact.tick + round(LOOK_ON / self.scene.tick)
        start, radius = self.track[begin, contact.agent], self.radii[contact.agent]
        clear = numpy.ones(len(velocities), dtype=bool)
        for tick in range(begin + 1, end + 1):
            places = start + (tick - begin) * self.scene.tick * velocities
            clear &= are_apart(places, self.obstacles[tick], radius + self.obstacle_radii)
            if among_others and tick < len(self.track):
                others = numpy.arange(len(self.radii)) != contact.agent
                clear &= are_apart(places, self.track[tick, others], radius + self.radii[others])
            for wall in self.scene.walls:
                clear &= distances_to_wall(places, wall) >= radius - OVERLAP
        return clear

    def had_turned(self, contact):
        """Returns whether the obstacle changed its direction within TURNED_WITHIN before the contact."""
        begin = max(0, contact.tick - round(TURNED_WITHIN / self.scene.tick))
        steps = numpy.diff(self.obstacles[begin:contact.tick + 1, contact.obstacle], axis=0)
        return bool((numpy.abs(steps - steps[-1]) > 1e-6).any())


def are_apart(places, others, reaches):
    """Returns for each place whether it is clear of all others; others that are nan are ignored."""
    away = places[:, None] - others[None]
    return ~(numpy.hypot(away[..., 0], away[..., 1]) < reaches - OVERLAP).any(axis=1)


def distances_to_wall(places, wall):
    """Returns the distances of places (n, 2) to a wall [m]."""
    begin, end = numpy.array(wall[0]), numpy.array(wall[1])
    along = end - begin
    share = numpy.clip((places - begin) @ along / (along @ along), 0.0, 1.0)
    away = places - begin - share[:, None] * along
    return numpy.hypot(away[:, 0], away[:, 1])
