#!/usr/bin/python3
"""The node crowd_editor: interactive markers, and goals for the chosen agent."""
import rospy
import support
from controlling import ControllerTestCase
from geometry_msgs.msg import Point, Pose, PoseStamped
from visualization_msgs.msg import InteractiveMarkerFeedback, InteractiveMarkerInit, InteractiveMarkerUpdate

SCENE = """
name: scene
duration: 60
goal_tolerance: 0.3
agents:
  - {position: [0, 0], goal: [20, 0], speed: 0.5, radius: 0.25}
  - {position: [0, 10], goal: [20, 10], speed: 0.5, radius: 0.25}
obstacles:
  - {position: [0, 30], radius: 0.4}
"""


class CrowdEditorTest(ControllerTestCase):
    """A paused crowd with an editor and a user, who is a publisher of feedback."""

    def start_editor(self, **parameters):
        """Starts the nodes and listens."""
        self.start_all(SCENE)
        self.start_node('crowd_markers', 'crowd_markers', {})
        self.start_node('crowd_editor', 'crowd_editor', parameters)
        self.lists = self.listen('crowd_editor/update_full', InteractiveMarkerInit)
        self.updates = self.listen('crowd_editor/update', InteractiveMarkerUpdate).wait_connected()
        self.user = rospy.Publisher(f'{self.namespace}/crowd_editor/feedback', InteractiveMarkerFeedback, queue_size=10)
        support.wait_for(self.user.get_num_connections, 'the editor')

    def places(self):
        """Returns {name: place} of the markers that RViz has now. A list of all of them is latched and follows each
        update, so none is missed by a listener that connects late."""
        markers = [marker for each in self.lists.messages[-1:] for marker in each.markers]
        return {marker.name: (marker.pose.position.x, marker.pose.position.y) for marker in markers}

    def wait_names(self, *names):
        """Waits until RViz has exactly these markers."""
        support.wait_for(lambda: self.places().keys() == set(names), f'the markers {names}')

    def send(self, marker, event, x=0.0, y=0.0, entry=0):
        """Sends what RViz sends when a user does something with a marker."""
        self.user.publish(InteractiveMarkerFeedback(client_id='user', marker_name=marker, event_type=event,
                                                    menu_entry_id=entry, pose=Pose(position=Point(x, y, 0.0))))

    def drag(self, marker, x, y):
        """Drags a marker and drops it."""
        for event in (InteractiveMarkerFeedback.MOUSE_DOWN, InteractiveMarkerFeedback.POSE_UPDATE,
                      InteractiveMarkerFeedback.MOUSE_UP):
            self.send(marker, event, x, y)

    def pose_of(self, marker):
        """Returns where RViz shows a marker."""
        return self.places().get(marker)

    def moves_of(self, marker):
        """Returns how often a marker was moved, or drawn again, since RViz has it."""
        first = next(each.seq_num for each in self.lists.messages if marker in [one.name for one in each.markers])
        later = [update for update in list(self.updates.messages) if update.seq_num > first]
        return [one.name for update in later for one in update.markers + update.poses].count(marker)

    def wait_state(self, fits, what):
        """Walks until the state meets the condition. Returns it."""
        return support.wait_for(lambda: (lambda state: fits(state) and state)(self.walk()), what)

    ALL = 'agent_0', 'goal_0', 'agent_1', 'goal_1', 'obstacle_0'

    def test_markers_follow_the_crowd(self):
        self.start_editor()
        self.wait_names(*self.ALL)
        state = self.walk(5)
        place = state.agents[0].pose.x, state.agents[0].pose.y
        support.wait_for(lambda: self.pose_of('agent_0') == place, 'the marker of agent 0')
        self.do('remove_agent', agent=1)
        self.walk()
        self.wait_names('agent_0', 'goal_0', 'obstacle_0')

    def test_dropped_markers_move_agents_goals_and_obstacles(self):
        self.start_editor()
        self.wait_names(*self.ALL)
        self.drag('agent_0', 5.0, 3.0)
        self.wait_state(lambda state: state.agents[0].pose.x >= 5.0, 'agent 0 at its new place')
        self.drag('goal_1', 6.0, 6.0)
        self.wait_state(lambda state: (state.agents[1].goal.x, state.agents[1].goal.y) == (6.0, 6.0), 'the new goal')
        self.drag('obstacle_0', 1.0, 20.0)
        self.wait_state(lambda state: state.obstacles[0].position.y == 20.0, 'the obstacle at its new place')

    def test_refused_drop_puts_the_marker_back(self):
        self.start_editor()
        self.wait_names(*self.ALL)
        self.drag('agent_0', 0.0, 30.0)  # in the obstacle
        support.wait_for(lambda: self.moves_of('agent_0'), 'the marker that is put back')
        self.assertEqual(self.pose_of('agent_0'), (0.0, 0.0))
        self.assertEqual(self.walk().agents[0].pose.y, 0.0)

    def test_what_is_done_with_a_handle_of_a_removed_obstacle_affects_no_other_one(self):
        """Numbers of obstacles change when one is removed, so handles change their names."""
        self.start_editor()
        for x in (5.0, 8.0):
            self.do('spawn_obstacle', position=Point(x, 30.0, 0.0), radius=0.4)
        self.walk()
        self.wait_names(*self.ALL, 'obstacle_1', 'obstacle_2')
        self.send('obstacle_1', InteractiveMarkerFeedback.POSE_UPDATE, 5.0, 29.0)  # it is held
        self.do('remove_obstacle', obstacle=0)
        self.walk()
        self.send('obstacle_1', InteractiveMarkerFeedback.MOUSE_UP, 5.0, 20.0)
        self.send('obstacle_0', InteractiveMarkerFeedback.MENU_SELECT, entry=1)
        names = 'obstacle_0_after_1', 'obstacle_1_after_1'
        self.wait_names(*self.ALL[:4], *names)
        self.drag(names[1], 8.0, 20.0)  # feedback is taken in its order
        state = self.wait_state(lambda state: state.obstacles[-1].position.y == 20.0, 'the drop of the new handle')
        self.assertEqual([(o.position.x, o.position.y) for o in state.obstacles], [(5.0, 30.0), (8.0, 20.0)])

    def test_menu_removes_and_chooses(self):
        self.start_editor()
        self.wait_names(*self.ALL)
        self.send('goal_1', InteractiveMarkerFeedback.MENU_SELECT, entry=2)
        self.send('obstacle_0', InteractiveMarkerFeedback.MENU_SELECT, entry=1)
        self.wait_state(lambda state: not state.obstacles, 'a floor without obstacles')
        self.send('agent_0', InteractiveMarkerFeedback.MENU_SELECT, entry=1)
        self.wait_state(lambda state: state.agents[0].status == 2, 'the removed agent')

    def test_robots_are_moved_and_removed(self):
        """Also while the crowd is paused."""
        self.start_editor()
        self.wait_names(*self.ALL)
        for name, y in (('tug', 5.0), ('cart', 15.0)):
            self.do('spawn_robot', robot=f'{{name: {name}, position: [0, {y}], radius: 0.3, max_speed: 1}}')
        self.wait_names(*self.ALL, 'robot_tug', 'robot_cart')
        self.drag('robot_tug', 5.0, 6.0)
        support.wait_for(lambda: self.moves_of('robot_tug') and self.pose_of('robot_tug') == (5.0, 6.0), 'the place')
        self.drag('robot_cart', 0.0, 30.0)  # in the obstacle
        support.wait_for(lambda: self.pose_of('robot_cart') == (0.0, 15.0) and self.moves_of('robot_cart'),
                         'the marker that is put back')
        for name in ('tug', 'cart'):
            self.send(f'robot_{name}', InteractiveMarkerFeedback.MENU_SELECT, entry=1)
        self.wait_names(*self.ALL)

    def test_of_many_agents_the_chosen_one_has_markers(self):
        self.start_editor(max_handles=1)
        self.wait_names('agent_0', 'goal_0', 'obstacle_0')
        self.succeed('crowd_markers/choose_agent', agent=1)
        self.wait_names('agent_1', 'goal_1', 'obstacle_0')

    def test_goal_is_that_of_the_chosen_agent(self):
        self.start_editor(max_handles=1)
        self.succeed('crowd_markers/choose_agent', agent=1)
        self.wait_names('agent_1', 'goal_1', 'obstacle_0')
        goals = rospy.Publisher(f'{self.namespace}/chosen_agent/goal', PoseStamped, queue_size=10)
        support.wait_for(goals.get_num_connections, 'the editor')
        goal = PoseStamped(pose=Pose(position=Point(3.0, 4.0, 0.0)))
        goal.header.frame_id = 'map'
        goals.publish(goal)
        self.wait_state(lambda state: (state.agents[1].goal.x, state.agents[1].goal.y) == (3.0, 4.0), 'the goal')


if __name__ == '__main__':
    support.run('crowd_editor_test')
