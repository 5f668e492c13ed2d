"""multi.launch: learners on other hosts, over ssh. The env-loader is that of docs/machines.md."""
import os

import pytest
import ssh_hosts
from host_crowds import AGENTS, crowd_scenario
from network_hosts import programs_in
from programs import (ANTICIPATION_TABLE, PATIENCE, assert_same_recording, assert_says, in_package, page_examples,
                      read_bytes, tools_folder, wait_for)

ENV_LOADER = 'crowd_env.sh'
SETUP = '/home/ada/catkin_ws/devel/setup.sh'  # on the page


@pytest.fixture(name='ssh')
def make_ssh(runner, network):
    """Three hosts: crowd, brain1 and brain2."""
    if ssh_hosts.why_not():
        pytest.skip(ssh_hosts.why_not())
    for name in ('crowd', 'brain1', 'brain2'):
        network.add(name)
    return ssh_hosts.SshHosts(runner)


def env_loader(runner):
    """Writes the env-loader of the page with the setup file of this build. Returns its path."""
    text = page_examples('machines.md')[ENV_LOADER]
    assert text.count(SETUP) == 1
    file = runner.write(ENV_LOADER, text.replace(SETUP, os.path.join(tools_folder(), '..', '..', 'setup.sh')))
    os.chmod(file, 0o755)
    return file


def launch(runner, network, ssh, hosts, **arguments):
    """Starts multi.launch on the first host."""
    defaults = {'hosts': hosts, 'env_loader': env_loader(runner), 'rviz': 'false', 'answer_deadline': 60,
                'start_deadline': 120, 'real_time_factor': 'fast', 'ssh_timeout': 80}
    words = [f'{name}:={value}' for name, value in dict(defaults, **arguments).items()]
    crowd = network.hosts[0]
    return runner.start('roslaunch', crowd.command('roslaunch', 'social_crowd', 'multi.launch', *words),
                        {**crowd.environment(), 'HOME': ssh.home})


def programs_of(network):
    """Returns names of the programs of ROS on the hosts of the learners."""
    names = []
    for host in network.hosts[1:]:
        for process in programs_in(host.namespace):
            try:
                with open(f'/proc/{process}/cmdline', 'rb') as stream:
                    names.append(stream.read().decode().replace('\0', ' '))
            except OSError:
                pass  # it has just ended
    return [name for name in names if 'sshd' not in name]


def is_over(network):
    """Returns whether nothing runs on the hosts of the learners but the ssh server."""
    return not programs_of(network)


class MultiLaunchTest:
    """Learners on two hosts."""

    def test_the_same_trajectories_as_on_one_machine(self, runner, network, ssh):
        """The whole launch, over ssh; all learners end with it."""
        for host in network.hosts[1:]:
            ssh.serve(host)
        scenario = runner.write('crowd.yaml', crowd_scenario(20))
        launched = launch(runner, network, ssh, ' '.join(host.address for host in network.hosts[1:]), seed=5,
                          episodes=1, scenario=scenario, trajectories=runner.path('walk'))
        assert launched.wait(3 * PATIENCE) == 0, launched.output()
        for number, host in enumerate(network.hosts[1:]):
            assert_says(launched.output(), f'remote[{host.address}-{number}]: ssh connection created')
        assert_says(launched.output(), f'0 of {AGENTS} agents arrived', ' 0 answers missed, 0 dropped')
        assert_same_recording(read_bytes(runner.path('walk/crowd.csv')),
                              runner.headless(scenario, ANTICIPATION_TABLE, episodes=1, seed=5))
        wait_for(lambda: is_over(network), 'the end of the programs on the other hosts')

    def test_interrupted_while_it_learns(self, runner, network, ssh):
        """Each learner saves its table on its host. One of the hosts is this one."""
        ssh.serve(network.hosts[1])
        launched = launch(runner, network, ssh, f'root@{network.hosts[1].address}:22 localhost', mode='training',
                          save_to=runner.path('table.txt'), scenario='circle6', real_time_factor=1)
        wait_for(lambda: 'process[learner_1' in launched.output() and not is_over(network), 'the learners')
        wait_for(lambda: sum('learner' in name for name in programs_of(network)) > 0, 'the learner over ssh')
        wait_for(lambda: is_served(network, runner), 'both learners to answer')
        assert launched.stop() == 0, launched.output()
        wait_for(lambda: is_over(network), 'the end of the programs on the other hosts')
        assert {'table_learner_0.txt', 'table_learner_1.txt'} <= set(os.listdir(runner.folder))

    def test_a_table_that_the_host_does_not_have(self, runner, network, ssh):
        """The message of the learner is shown on the first host."""
        ssh.serve(network.hosts[1])
        launched = launch(runner, network, ssh, network.hosts[1].address, q_table='anticipatoin')
        wait_for(lambda: "no Q-table 'anticipatoin', did you mean 'anticipation'?" in launched.output(), 'the message')
        assert launched.stop() == 0, launched.output()
        print(launched.output())
        wait_for(lambda: is_over(network), 'the end of the programs on the other hosts')

    def test_a_host_without_an_ssh_server(self, runner, network, ssh):
        """Nothing starts, and what has started ends."""
        ssh.serve(network.hosts[1])
        with open(os.path.join(ssh.home, '.ssh', 'known_hosts'), encoding='utf-8') as stream:
            known = stream.read()
        with open(os.path.join(ssh.home, '.ssh', 'known_hosts'), 'a', encoding='utf-8') as stream:
            stream.write(known.replace(network.hosts[1].address, network.hosts[2].address))
        launched = launch(runner, network, ssh, ' '.join(host.address for host in network.hosts[1:]))
        assert launched.wait() != 0
        assert_says(launched.output(), f'network error connecting to [{network.hosts[2].address}:22]',
                    'unable to start remote roslaunch child')
        wait_for(lambda: is_over(network), 'the end of the programs on the other hosts')

    def test_a_host_that_ssh_does_not_know(self, runner, network, ssh):
        launched = launch(runner, network, ssh, network.hosts[1].address)
        assert launched.wait() != 0
        assert_says(launched.output(), f'{network.hosts[1].address} is not in your SSH known_hosts file')

    def test_a_name_that_is_no_host(self, runner, network, ssh):
        launched = launch(runner, network, ssh, 'nowhere.invalid')
        assert launched.wait() != 0
        assert_says(launched.output(), 'cannot resolve host address for machine [nowhere.invalid]')


class ArgumentsTest:
    """Arguments of multi.launch, without ssh."""

    def dump(self, runner, **arguments):
        """Returns the parameters that the launch would set, by name."""
        words = [f'{name}:={value}' for name, value in dict({'env_loader': '/env.sh'}, **arguments).items()]
        done = runner.start('roslaunch', ['roslaunch', '--dump-params', 'social_crowd', 'multi.launch', *words])
        done.wait()
        lines = [line.partition(': ') for line in done.output().splitlines()]
        return {name: value for name, _, value in lines}, done.output()

    def test_each_host_has_its_share(self, runner):
        found, _ = self.dump(runner, hosts='a bob@b:2222 localhost', q_table='/a.txt /b.txt human')
        assert [found[f'/learner_{i}/share'] for i in range(3)] == ['0', '1', '2']
        assert {found[f'/learner_{i}/shares'] for i in range(3)} == {'3'}
        assert [found[f'/learner_{i}/q_table'] for i in range(3)] == ['/a.txt', '/b.txt', 'human']
        assert '/learner_3/share' not in found and '/learner/q_table' not in found

    def test_places_have_the_table_of_demo_launch(self, runner):
        assert self.dump(runner, hosts='a', scenario='place_station')[0]['/learner_0/q_table'] == 'human'
        assert self.dump(runner, hosts='a')[0]['/learner_0/q_table'] == 'anticipation'

    @pytest.mark.parametrize('arguments, part', [
        ({'hosts': ''}, 'hosts: expected at least one host'),
        ({'hosts': 'a b c', 'q_table': 'human anticipation'}, 'q_table: expected one table, or one for each host'),
        ({'hosts': 'a', 'env_loader': '/x /y'}, 'env_loader: expected one script, or one for each host'),
        ({'hosts': 'a', 'env_loader': ''}, 'env_loader'),
        ({'hosts': 'a:port'}, "'port'"),
    ])
    def test_bad_arguments(self, runner, arguments, part):
        _, output = self.dump(runner, **arguments)
        assert_says(output, 'Unable to load file', part)


def is_served(network, runner):
    """Returns whether all agents walk."""
    crowd = network.hosts[0]
    look = runner.start('look', crowd.command('rostopic', 'echo', '-n', '1', '/controller_status'), crowd.environment())
    look.wait()
    return 'walking: 6' in look.output() and 'unanswered: []' in look.output() and 'decisions: 0' not in look.output()


def test_the_page_is_in_the_package():
    assert ENV_LOADER in page_examples('machines.md')
    assert os.access(in_package('launch', 'multi.launch'), os.R_OK)
