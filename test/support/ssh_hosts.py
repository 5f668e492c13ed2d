"""ssh between hosts in network namespaces: servers with keys of their own, and a user whose keys they accept."""
import importlib.util
import os
import shutil
import subprocess

from programs import wait_for

SERVER = '/usr/sbin/sshd'
PRIVILEGES = '/run/sshd'  # folder that sshd requires
CONFIGURATION = '''
HostKey {folder}/host_key
AuthorizedKeysFile {folder}/user/.ssh/id_ed25519.pub
PidFile none
StrictModes no
UsePAM no
PasswordAuthentication no
PermitRootLogin yes
SetEnv ROS_HOME={folder}/ros ROS_LOG_DIR={folder}/ros/log
'''


def why_not():
    """Returns why there can be no ssh here; an empty text if there can."""
    if not os.path.exists(SERVER) or shutil.which('ssh-keygen') is None:
        return f'there is no ssh server {SERVER}'
    if importlib.util.find_spec('paramiko') is None:
        return 'roslaunch needs paramiko to reach other hosts, which is missing (python3-paramiko)'
    return ''


class SshHosts:
    """Keys, and servers on hosts."""

    def __init__(self, runner):
        self.runner = runner
        self.home = runner.path('user')  # of the user of ssh
        os.makedirs(os.path.join(self.home, '.ssh'))
        os.makedirs(PRIVILEGES, exist_ok=True)
        for key in ('host_key', 'user/.ssh/id_ed25519'):
            subprocess.run(['ssh-keygen', '-q', '-t', 'ed25519', '-N', '', '-f', runner.path(key)], check=True)
        self.configuration = runner.write('sshd_config', CONFIGURATION.format(folder=runner.folder))

    def serve(self, host):
        """Starts the server of a host, which the user knows."""
        server = self.runner.start(f'{host.name}_sshd', host.command(SERVER, '-D', '-e', '-f', self.configuration),
                                   host.environment())
        server.is_given_up = True  # its exit status after a signal does not matter
        wait_for(lambda: 'Server listening on 0.0.0.0' in server.output(), f'the ssh server of {host.name}')
        with open(self.runner.path('host_key.pub'), encoding='utf-8') as stream:
            key = ' '.join(stream.read().split()[:2])
        with open(os.path.join(self.home, '.ssh', 'known_hosts'), 'a', encoding='utf-8') as stream:
            stream.write(f'{host.address} {key}\n')
