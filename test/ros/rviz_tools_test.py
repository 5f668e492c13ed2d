#!/usr/bin/python3
"""The tools in a real RViz on a separate screen: dragging on the floor with the mouse."""
import os
import signal
import time

import support
from controlling import ControllerTestCase
from screens import DrivenRviz, Screen
from social_crowd.msg import RobotStates, Walls

# The centre of the scene is the origin, so it is in the middle of the view.
SCENE = """
name: scene
duration: 60
goal_tolerance: 0.3
agents:
  - {position: [-3, 0], goal: [3, 0], speed: 0.5, radius: 0.25}
  - {position: [0, -3], goal: [0, 3], speed: 0.5, radius: 0.25}
obstacles:
  - {position: [3, 3], radius: 0.4}
  - {position: [-3, -3], radius: 0.4}
"""
SCALE = 66.0  # [pixels/m], that of rviz/social_crowd.rviz
HOVERS, HOVER = 10, 0.1  # moves before a drag, and the time between them [s]
CLOSE = 0.05  # [m]; three pixels


class ToolsTestCase(ControllerTestCase):
    """RViz with a paused crowd in the middle of its view."""

    scene = SCENE

    def setUp(self):
        super().setUp()
        self.screen = Screen()
        self.addCleanup(self.screen.close)
        self.walls = self.listen('walls', Walls)
        self.start_all(self.scene)
        self.start_node('crowd_markers', 'crowd_markers', {})
        self.start_node('crowd_editor', 'crowd_editor', {})
        self.rviz = self.open_rviz()

    def open_rviz(self, name='rviz'):
        """Opens RViz, and waits until it has found the controller."""
        rviz = DrivenRviz(self.screen, self.namespace, name, log=self.path(f'{name}.log'))
        self.addCleanup(rviz.clean_up)
        rviz.wait_enabled('step')
        return rviz

    def pixel(self, x, y):
        """Returns where a point of the floor [m] is on the screen."""
        middle = self.rviz.place('rviz::RenderPanel')
        return round(middle[0] + SCALE * x), round(middle[1] - SCALE * y)

    def drag(self, begin, end):
        """Drags with the left button from one point of the floor to another [m]."""
        x, y = self.pixel(*begin)
        for jiggle in range(HOVERS):  # a drag of a marker that RViz has not noticed under the mouse turns the view
            self.screen.use('mousemove', x + jiggle % 2, y)
            time.sleep(HOVER)
        for jiggle in (1, 0):  # it looks once in a frame, and a busy machine draws few
            self.wait_frame()
            self.screen.use('mousemove', x + jiggle, y)
        self.wait_frame()
        self.screen.use('mousemove', x, y, 'mousedown', 1)
        for share in (0.25, 0.5, 0.75, 1.0):
            self.screen.use('mousemove', *self.pixel(*(b + share * (e - b) for b, e in zip(begin, end))))
        self.screen.use('mouseup', 1)

    def wait_frame(self):
        """Waits until RViz has handled the moves of the mouse, and has drawn once more."""
        self.rviz.ask('pressed', 'rviz::RenderPanel')
        before = int(self.rviz.ask('frames', ''))
        support.wait_for(lambda: int(self.rviz.ask('frames', '')) > before, 'a frame of RViz')

    def newest(self, fits, what):
        """Waits until the newest state of the agents meets the condition. Returns it."""
        return support.wait_for(lambda: self.agents.messages and fits(self.agents.messages[-1]) and
                                self.agents.messages[-1], what)

    def state_after(self, fits, what):
        """Walks single ticks until the state meets the condition. Returns it."""
        return support.wait_for(lambda: (lambda state: fits(state) and state)(self.walk()), what)

    def assert_close(self, got, expected):
        """Checks that a point is where the mouse was."""
        self.assertLess(max(abs(got.x - expected[0]), abs(got.y - expected[1])), CLOSE, (got, expected))


class DrawingTest(ToolsTestCase):
    """Tools that add to the floor."""

    def test_agent_is_added(self):
        self.rviz.click('Add agent')
        self.drag((-2, 2), (2, 2))
        state = self.state_after(lambda state: len(state.agents) == 3, 'a third agent')
        self.assert_close(state.agents[2].goal, (2, 2))
        self.assertAlmostEqual(state.agents[2].pose.y, 2, delta=CLOSE)
        self.assertAlmostEqual(state.agents[2].max_speed, 1.3, places=6)

    def test_obstacle_is_added(self):
        self.rviz.click('Add obstacle')
        self.drag((1, 1), (1.6, 1))
        state = self.state_after(lambda state: len(state.obstacles) == 3, 'a third obstacle')
        self.assert_close(state.obstacles[2].position, (1, 1))
        self.assertAlmostEqual(state.obstacles[2].radius, 0.6, delta=CLOSE)

    def test_wall_is_drawn(self):
        self.rviz.click('Draw wall')
        self.drag((-1, 1), (1, 2))
        walls = self.walls.wait(lambda message: len(message.walls) == 1, 'with a wall')
        self.assert_close(walls.walls[0].from_, (-1, 1))
        self.assert_close(walls.walls[0].to, (1, 2))

    def test_source_is_added(self):
        self.rviz.click('Add source')
        self.drag((-2, 2), (2, 2))
        state = self.state_after(lambda state: len(state.agents) > 2, 'an agent of the source')
        self.assert_close(state.agents[2].goal, (2, 2))
        self.assertAlmostEqual(state.agents[2].pose.y, 2, delta=CLOSE)

    def test_gate_is_added(self):
        self.rviz.click('Add gate')
        self.drag((-1, 1), (1, 2))
        walls = self.walls.wait(lambda message: len(message.walls) == 1, 'with a closed gate')
        self.assert_close(walls.walls[0].from_, (-1, 1))
        self.do('set_gate', gate='gate_0', open=True)
        self.walls.wait(lambda message: not message.walls, 'without it')

    def test_robots_are_added(self):
        """The second one by a click, without a goal."""
        states = self.listen('robots', RobotStates)
        self.rviz.click('Add robot')
        self.drag((-2, 2), (2, 2))
        robot = self.newest_robots(states, 1)[0]
        self.assertEqual(robot.name, 'robot_0')
        self.assert_close(robot.pose, (-2, 2))
        self.assert_close(robot.goal, (2, 2))
        self.assertAlmostEqual(robot.radius, 0.3, places=6)
        self.drag((-1, -2), (-1, -2))
        robot = self.newest_robots(states, 2)[1]
        self.assertEqual((robot.name, robot.has_goal), ('robot_1', False))
        self.assert_close(robot.pose, (-1, -2))

    def newest_robots(self, states, count):
        """Waits until there are `count` robots. Returns their states."""
        return support.wait_for(lambda: states.messages and len(states.messages[-1].robots) == count and
                                states.messages[-1].robots, f'{count} robots')

    def test_right_button_abandons(self):
        self.rviz.click('Draw wall')
        self.screen.use('mousemove', *self.pixel(-1, 1), 'mousedown', 1, 'mousemove', *self.pixel(1, 1))
        self.screen.use('click', 3, 'mouseup', 1)
        self.drag((-1, 2), (1, 2))
        walls = self.walls.wait(lambda message: message.walls, 'with a wall')
        self.assertEqual(len(walls.walls), 1)
        self.assert_close(walls.walls[0].from_, (-1, 2))

    def test_refusal_leaves_the_floor_as_it_is(self):
        self.rviz.click('Add agent')
        self.drag((3, 3), (0, 0))  # in the obstacle
        self.drag((-2, 2), (2, 2))
        state = self.state_after(lambda state: len(state.agents) > 2, 'a third agent')
        self.assert_close(state.agents[2].goal, (2, 2))


class TroubleTest(ToolsTestCase):
    """Nodes that go away or hang, two RViz."""

    def draw_wall(self, y):
        """Draws a wall from (-1, y) to (1, y) [m]."""
        self.rviz.click('Draw wall')
        self.drag((-1, y), (1, y))

    def warnings(self):
        """Returns what RViz has printed."""
        return support.read_text(self.path('rviz.log')) if os.path.exists(self.path('rviz.log')) else ''

    def test_controller_goes_away_and_comes_back(self):
        self.controller.kill()
        self.rviz.wait_enabled('step', False)
        self.draw_wall(1)
        support.wait_for(lambda: 'crowd_controller/add_wall' in self.warnings(), 'a warning about the wall')
        self.controller = self.start_controller(self.file, paused=True)
        self.rviz.wait_enabled('step')
        self.draw_wall(2)
        walls = self.walls.wait(lambda message: message.walls, 'with a wall')
        self.assertEqual(len(walls.walls), 1)
        self.assert_close(walls.walls[0].from_, (-1, 2))

    def test_rviz_is_closed_while_the_controller_hangs(self):
        self.addCleanup(self.controller.signal, signal.SIGCONT)
        self.controller.signal(signal.SIGSTOP)
        self.draw_wall(1)
        self.assertEqual(self.rviz.close(), 0)

    def test_rviz_goes_on_while_the_controller_hangs(self):
        self.addCleanup(self.controller.signal, signal.SIGCONT)
        self.controller.signal(signal.SIGSTOP)
        self.draw_wall(1)
        self.assertTrue(self.rviz.is_enabled('learner'))  # RViz answers
        self.controller.signal(signal.SIGCONT)
        self.walls.wait(lambda message: len(message.walls) == 1, 'with a wall')

    def test_two_rviz(self):
        first, self.rviz = self.rviz, self.open_rviz('second')  # above the first one
        self.draw_wall(1)
        self.walls.wait(lambda message: len(message.walls) == 1, 'with a wall')
        self.assertEqual(self.rviz.close(), 0)
        self.rviz = first
        self.draw_wall(2)
        self.walls.wait(lambda message: len(message.walls) == 2, 'with two walls')


class CrowdTest(ToolsTestCase):
    """A thousand agents."""

    scene = support.read_text(support.in_package('config', 'scenarios', 'crowd_random_1000.yaml'))

    def test_wall_is_drawn_in_a_thousand_agents(self):
        self.assertEqual(len(self.walk().agents), 1000)
        # Where the wall may be depends on the agents: the floor is full of them.
        self.do('set_real_time_factor', factor=0)
        self.do('pause', data=False)
        self.rviz.click('Draw wall')

        def draw_and_look():
            self.drag((-0.2, 0), (0.2, 0))
            return any(message.walls for message in self.walls.messages)
        support.wait_for(draw_and_look, 'a wall')
        self.assertTrue(self.controller.is_running())


class MovingTest(ToolsTestCase):
    """Interactive markers, and the tool 2D Nav Goal."""

    def setUp(self):
        super().setUp()
        self.rviz.click('Interact')

    def drag_until(self, begin, end, fits, what):
        """Drags until the state meets the condition; at first RViz may not have the markers yet."""
        def drag_and_look():
            self.drag(begin, end)
            return fits(self.walk())
        support.wait_for(drag_and_look, what)

    def test_goal_is_dragged(self):
        self.drag_until((3, 0), (2, 2), lambda state: abs(state.agents[0].goal.x - 2) < CLOSE, 'the goal')
        self.assert_close(self.walk().agents[0].goal, (2, 2))

    def test_obstacle_is_dragged(self):
        def is_there(state):
            return any(abs(obstacle.position.x - 1.5) < CLOSE for obstacle in state.obstacles)
        self.drag_until((3, 3), (1.5, 1.5), is_there, 'the obstacle')
        self.assertEqual(len(self.walk().obstacles), 2)

    def test_agent_is_dragged(self):
        def is_there(state):
            return abs(state.agents[0].pose.y - 1.5) < 0.5
        self.drag_until((-3, 0), (-2, 1.5), is_there, 'the agent')

    def test_nav_goal_is_that_of_the_chosen_agent(self):
        self.succeed('crowd_markers/choose_agent', agent=1)

        def send_and_look():
            self.rviz.click('2D Nav Goal')
            self.drag((-2, 1), (-2, 2))
            return abs(self.walk().agents[1].goal.x + 2) < CLOSE
        support.wait_for(send_and_look, 'the goal of the chosen agent')
        self.assert_close(self.walk().agents[1].goal, (-2, 1))


if __name__ == '__main__':
    support.run('rviz_tools_test')
