"""A scene with its recording, of which the tests make films."""
import numpy
import PIL.Image
import PIL.ImageSequence

LINE = '''name: line
duration: 10
goal_tolerance: 0.3
agents:
  - {position: [0, 0], goal: [4, 0], speed: 1, radius: 0.5}
  - {position: [0, 3], goal: [4, 3], speed: 1, radius: 0.25}
obstacles:
  - {position: [2, -2], radius: 0.5, velocity: [0.5, 0]}
'''
# Agent 0 walks 4 s to the right at 1 m/s, agent 1 stands until 2 s and leaves.
WALKS = 'instance,tick,agent,x,y\n' + ''.join(
    f'0,{tick},0,{tick / 10},0\n' + (f'0,{tick},1,0,3\n' if tick <= 20 else '') for tick in range(41))


def recorded(runner):
    """Writes the scene and its recording. Returns the arguments for them."""
    return runner.write('line.yaml', LINE), '--trajectories', runner.write('line.csv', WALKS)


def frames_of(file):
    """Returns the frames of a moving picture as arrays of RGB."""
    with PIL.Image.open(file) as picture:
        return [numpy.asarray(frame.convert('RGB')) for frame in PIL.ImageSequence.Iterator(picture)]
