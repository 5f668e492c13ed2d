"""Other walking models, which predict the same Tasks: social force; ORCA and models of JuPedSim where the packages rvo2
and jupedsim are installed."""
import importlib.util

import numpy

from .crowds import SLOWEST
from .people import PREDICTED, STEP

TICK, TICKS = 0.1, round(STEP / 0.1)  # [s] of both models
# Helbing and Molnar, Social force model for pedestrian dynamics, 1995.
RELAXATION, STRENGTH, RANGE, STRIDE = 0.5, 2.1, 0.3, 2.0  # [s], [m²/s²], [m], [s]
SIGHT, BEHIND, FASTEST = numpy.cos(numpy.radians(100)), 0.5, 1.3  # limit of sight, weight beyond it, of the free speed
NEIGHBOURS, HORIZON = 10, 5.0  # of ORCA: number and distance [m] as in the examples of RVO2, [s]
REACH = 15.0
FINE = 0.01  # [s] step of JuPedSim


def towards(goals, places):
    ways = goals - places
    return ways / numpy.maximum(numpy.hypot(*ways.T), 1e-9)[:, None]


def repulsion(places, velocities, directions):
    """Returns the sum of the forces of all others on each person [m/s²]."""
    apart = places[:, None] - places[None]
    strides = (velocities * STRIDE)[None]
    ahead = apart - strides
    near, far = (numpy.maximum(numpy.linalg.norm(vectors, axis=2), 1e-6) for vectors in (apart, ahead))
    axis = 0.5 * numpy.sqrt(numpy.maximum((near + far)**2 - (strides**2).sum(axis=2), 1e-6))
    slope = ((near + far) / (4 * axis))[..., None] * (apart / near[..., None] + ahead / far[..., None])
    forces = (STRENGTH / RANGE * numpy.exp(-axis / RANGE))[..., None] * slope
    is_seen = (-forces * directions[:, None]).sum(axis=2) >= SIGHT * numpy.linalg.norm(forces, axis=2)
    weights = numpy.where(is_seen, 1.0, BEHIND)
    numpy.fill_diagonal(weights, 0.0)
    return (weights[..., None] * forces).sum(axis=1)


def social_force(tasks, radius):
    """Predicts with the social force model, its published parameters, and observed speeds as free speeds. Its people
    have no radius."""
    del radius
    found = []
    for task in tasks:
        places, velocities, speeds = task.places.copy(), task.velocities.copy(), task.speeds()[:, None]
        steps = []
        for _ in range(PREDICTED * TICKS):
            directions = towards(task.goals, places)
            drive = (speeds * directions - velocities) / RELAXATION
            velocities = velocities + TICK * (drive + repulsion(places, velocities, directions))
            size = numpy.maximum(numpy.hypot(*velocities.T), 1e-9)[:, None]
            velocities *= numpy.minimum(1.0, FASTEST * speeds / size)
            places = places + TICK * velocities
            steps.append(places)
        found.append(numpy.stack(steps[TICKS - 1::TICKS], axis=1))
    return found


def orca(tasks, radius):
    """Predicts with RVO2."""
    import rvo2  # may be missing
    found = []
    for task in tasks:
        simulator = rvo2.PyRVOSimulator(TICK, REACH, NEIGHBOURS, HORIZON, HORIZON, radius, 2.0)
        speeds = task.speeds()
        for place, velocity, speed, size in zip(task.places, task.velocities, speeds, task.radii(radius)):
            simulator.addAgent(tuple(place), REACH, NEIGHBOURS, HORIZON, HORIZON, size, max(speed, SLOWEST),
                               tuple(velocity))
        steps = []
        for _ in range(PREDICTED * TICKS):
            places = numpy.array([simulator.getAgentPosition(i) for i in range(len(speeds))])
            lengths = numpy.hypot(*(task.goals - places).T)
            wanted = towards(task.goals, places) * numpy.minimum(speeds, lengths / TICK)[:, None]
            for i, velocity in enumerate(wanted):
                simulator.setAgentPrefVelocity(i, tuple(velocity))
            simulator.doStep()
            steps.append([simulator.getAgentPosition(i) for i in range(len(speeds))])
        found.append(numpy.stack(numpy.array(steps)[TICKS - 1::TICKS], axis=1))
    return found


def jupedsim_model(name):
    """Returns a function that predicts with a model of JuPedSim and its default parameters."""
    import jupedsim  # may be missing

    def predict(tasks, radius):
        found = []
        for task in tasks:
            kind = getattr(jupedsim, name)
            low, high = (numpy.concatenate([task.places, task.goals]).min() - REACH,
                         numpy.concatenate([task.places, task.goals]).max() + REACH)
            simulation = jupedsim.Simulation(model=kind(), dt=FINE, geometry=[(low, low), (high, low), (high, high),
                                                                              (low, high)])
            stage = simulation.add_direct_steering_stage()
            journey = simulation.add_journey(jupedsim.JourneyDescription([stage]))
            people = []
            for place, goal, speed, size in zip(task.places, task.goals, task.speeds(), task.radii(radius)):
                people.append(simulation.add_agent(getattr(jupedsim, f'{name}AgentParameters')(
                    position=tuple(place), journey_id=journey, stage_id=stage, desired_speed=max(speed, SLOWEST),
                    radius=size)))
                simulation.agent(people[-1]).target = tuple(goal)
            steps = []
            for _ in range(PREDICTED):
                simulation.iterate(round(STEP / FINE))
                steps.append([simulation.agent(person).position for person in people])
            found.append(numpy.stack(numpy.array(steps), axis=1))
        return found
    return predict


def installed():
    """Returns the models that can be run, functions of Tasks and a radius [m], by name."""
    models = {'social force': social_force}
    if importlib.util.find_spec('rvo2'):
        models['ORCA'] = orca
    if importlib.util.find_spec('jupedsim'):
        models['collision-free speed'] = jupedsim_model('CollisionFreeSpeedModel')
        models['anticipation velocity'] = jupedsim_model('AnticipationVelocityModel')
    return models
