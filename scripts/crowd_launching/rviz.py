"""Runs RViz with a configuration for the current crowd."""
import concurrent.futures
import glob
import os
import sys
import tempfile

import rospkg
import rospy
import yaml
from crowd_drawing.errors import read_documents
from social_crowd.msg import Scenario

from .program import Program, end_launch

VIEW = 900.0, 700.0  # [pixels] available in a window of the configuration's size
MARGIN = 1.0  # [m] around it
LEAST, MOST = 0.5, 100.0  # [pixels/m]
PATIENCE = 10.0  # [s] time to wait for a scenario
GRAPHICS = '/dev/dri/*', '/dev/nvidia[0-9]*', '/dev/dxg'  # devices with which OpenGL draws in hardware


def draws_in_software(environment, devices=GRAPHICS):
    """Returns whether OpenGL draws without graphics hardware here, as far as that can be known."""
    forced = environment.get('LIBGL_ALWAYS_SOFTWARE', '').lower() in ('1', 'true', 'yes', 'y')
    return forced or not any(glob.glob(device) for device in devices)


def sides_of(scenario):
    """Returns width and height of the box of all that a Scenario has [m]; an empty list if it has nothing."""
    points = [point for agent in scenario.agents for point in (agent.pose, agent.goal)]
    points += [obstacle.position for obstacle in scenario.obstacles]
    points += [end for wall in scenario.walls for end in (wall.from_, wall.to)]  # `from` is a keyword of Python
    return [max(values) - min(values) for values in zip(*((point.x, point.y) for point in points))]


def scale_for(scenario):
    """Returns the scale [pixels/m] with which a whole Scenario is visible."""
    scales = [pixels / (side + 2 * MARGIN) for pixels, side in zip(VIEW, sides_of(scenario))]
    return min([MOST, *(max(LEAST, scale) for scale in scales)])


def configuration(view):
    """Returns a configuration of RViz as YAML, with the scale for the current crowd."""
    file = os.path.join(rospkg.RosPack().get_path('social_crowd'), 'rviz', view + '.rviz')
    settings, = read_documents(file)
    manager = settings['Visualization Manager']
    # A recording has no nodes that panel and tools of this package could call.
    for holder, key in ((settings, 'Panels'), (manager, 'Tools')) if not rospy.get_param('~controls', True) else ():
        holder[key] = [entry for entry in holder[key] if not entry['Class'].startswith('social_crowd/')]
    try:
        scenario = rospy.wait_for_message('scenario', Scenario, PATIENCE)
        manager['Views']['Current']['Scale'] = scale_for(scenario)
    except rospy.ROSException:
        rospy.logwarn('no scenario was received on %s', rospy.resolve_name('scenario'))
    return yaml.safe_dump(settings, sort_keys=False)


def prepare():
    """Returns the configuration, options, and whether closing RViz ends the launch, by the parameters of this node."""
    rospy.init_node('rviz', disable_signals=True)
    try:
        settings = configuration(rospy.get_param('~view', 'social_crowd'))
        smooth = rospy.get_param('~anti_aliasing', 'auto')
        if smooth == 'auto':  # in software, smooth edges take more time than all else together
            smooth = not draws_in_software(os.environ)
        return settings, [] if smooth else ['--disable-anti-aliasing'], rospy.get_param('~ends_launch', False)
    finally:
        rospy.signal_shutdown('RViz uses this node name')


def main():
    if not os.environ.get('DISPLAY'):
        print('show_crowd: there is no display for RViz (DISPLAY is not set); start the launch file with rviz:=false',
              file=sys.stderr)
        return 1
    # In a process that ends: a server of rospy keeps a processor busy after the shutdown of the node.
    with concurrent.futures.ProcessPoolExecutor(1) as process:
        settings, chosen, ends_launch = process.submit(prepare).result()
    with tempfile.TemporaryDirectory(prefix='social_crowd_rviz_') as folder:
        file = os.path.join(folder, 'social_crowd.rviz')
        with open(file, 'w', encoding='utf-8') as stream:
            stream.write(settings)
        rviz = Program(['rviz', '-d', file, *chosen, *sys.argv[1:]])
        status = rviz.wait()
    if ends_launch and status == 0 and not rviz.is_stopped:
        end_launch()
    return status
