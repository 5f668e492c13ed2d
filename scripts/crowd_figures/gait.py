"""Angles of a walking person's joints during a cycle of two steps, after the usual curves of gait analysis."""
import math

FRAMES = 8
HIP_SWING = 24.0  # [degrees] to each side: with a leg of 0.88 m a cycle of 1.4 m
ARM_SWING = 22.0


def bump(phase, middle, width):
    """A smooth hump of height 1 in a cycle of length 1."""
    away = (phase - middle + 0.5) % 1.0 - 0.5
    return math.exp(-(away / width) ** 2)


def leg(phase):
    """Angles of hip and knee [degrees] at a phase of the leg's cycle, 0 to 1; its heel touches the floor at 0."""
    knee = 4.0 + 12.0 * bump(phase, 0.14, 0.1) + 56.0 * bump(phase, 0.73, 0.12)
    return 3.0 + HIP_SWING * math.cos(2 * math.pi * phase), knee


def arm(phase):
    """Angles of shoulder and elbow [degrees] at the phase of the leg on the same side: the arm swings against it."""
    swing = -math.cos(2 * math.pi * phase)
    return ARM_SWING * swing, 22.0 + 12.0 * swing


def joints(frame):
    """Angles (hip, knee, shoulder, elbow) [degrees] of left and right in a frame; FRAMES: of a person who stands."""
    if frame == FRAMES:
        return [(0.0, 0.0, 0.0, 8.0)] * 2
    phase = (frame + 0.5) / FRAMES
    return [(*leg(part), *arm(part)) for part in (phase, (phase + 0.5) % 1.0)]
