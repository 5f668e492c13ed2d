"""Runs of the tools, each in its own folder, several in parallel, with a progress bar."""
import concurrent.futures
import functools
import hashlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
import typing

from crowd_drawing.errors import RunError

from . import scenario_files

WIDTH = 30
PLAIN_PERIOD = 10.0  # [s] between two lines without a terminal
# In a run's folder: digest of commands and input files; commands, their output, processor time.
STAMP, LOG = 'done.txt', 'log.txt'
PROCESSOR_TIME = 'processor time'


class ProgressBar:
    """Shows the progress of runs of different lengths, or of other things: `name` is their plural."""

    def __init__(self, total, runs, name='runs'):
        self.total, self.runs, self.name = total, runs, name
        self.done, self.runs_done, self.start = 0.0, 0, time.monotonic()
        self.is_terminal = sys.stderr.isatty()
        self.next = self.start if self.is_terminal else self.start + PLAIN_PERIOD

    def add(self, cost):
        self.done += cost
        self.runs_done += 1
        self.show()

    def show(self):
        """Draws the bar; without a terminal only periodically."""
        now = time.monotonic()
        if now < self.next:
            return
        self.next = now if self.is_terminal else now + PLAIN_PERIOD
        share = self.done / self.total if self.total else 1.0
        bar = '#' * round(share * WIDTH)
        left = text_of((now - self.start) * (1 - share) / share) if share else '?'
        line = (f'[{bar:.<{WIDTH}}] {self.runs_done}/{self.runs} {self.name}  took {text_of(now - self.start)}  '
                f'left {left}')
        sys.stderr.write(f'\r{line}\x1b[K' if self.is_terminal else f'{line}\n')
        sys.stderr.flush()

    def end(self):
        if self.is_terminal:
            sys.stderr.write('\n')


def text_of(seconds):
    """65 -> 1:05"""
    return f'{int(seconds) // 60}:{int(seconds) % 60:02d}'


def output_of(command, **options):
    """Runs a program. Returns its standard output. Raises RunError with the end of all output if it fails."""
    words = list(map(str, command))
    done = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False,
                          encoding='utf-8', errors='replace', **options)
    if done.returncode != 0:
        name, lines = pathlib.Path(words[0]).name, (done.stdout + done.stderr).strip().splitlines()
        raise RunError(f'{name}: ' + '\n'.join(lines[-20:] or ['no message']).removeprefix(f'{name}: '))
    return done.stdout


class Run(typing.NamedTuple):
    """Commands that are executed one after the other in a folder."""
    folder: pathlib.Path
    commands: list  # of lists of words; output files are relative to the folder
    cost: float = 1.0  # [s] approximate duration
    inputs: tuple = ()  # texts of what else determines the results

    def lines(self):
        return [' '.join(map(str, command)) for command in self.commands]

    def stamp(self):
        """Returns a digest of the commands, the programs, all files that they read, and the other inputs."""
        digest = hashlib.sha256()
        for text in self.inputs:
            digest.update(text.encode() + b'\0')
        for command in self.commands:
            for word in map(str, command):
                digest.update(word.encode() + b'\0')
                for file in files_behind(pathlib.Path(word)):
                    state = file.stat()
                    digest.update(digest_of(file, state.st_size, state.st_mtime_ns))
        return digest.hexdigest()

    def is_done(self):
        """Returns whether the results exist and were made with the current stamp."""
        try:
            return (self.folder / STAMP).read_text(encoding='utf-8') == self.stamp()
        except OSError:
            return False


def files_behind(path):
    """Returns the file that a word of a command names, and the files that it depends on."""
    if not (path.is_absolute() and path.is_file()):
        return []
    files = [path]
    if path.name == 'train' or path.name == 'evaluate':
        files += sorted(path.parent.parent.glob('libsocial_crowd_core.*'))
    if path.suffix == '.yaml':
        files += scenario_files.files_behind(path)
    return files


@functools.lru_cache(maxsize=None)
def digest_of(file, _size, _time):
    """Returns a digest of the contents of a file, which is read once while its size and time are the same."""
    return hashlib.sha256(file.read_bytes()).digest()


class Runner:
    """Executes runs, several in parallel, and can be stopped."""

    def __init__(self, processes):
        self.processes = processes
        self.lock = threading.Lock()
        self.children = set()
        self.stopped = False

    def carry_out(self, runs):
        """Executes all runs with a progress bar on standard error. Throws RunError when the first run fails."""
        bar = ProgressBar(sum(run.cost for run in runs), len(runs))
        bar.show()
        with concurrent.futures.ThreadPoolExecutor(self.processes) as pool:
            futures = {}
            try:
                for run in runs:  # may be interrupted, too: the first run may be done before the last one is here
                    futures[pool.submit(self.carry_out_one, run)] = run
                waiting = set(futures)
                while waiting:
                    done, waiting = concurrent.futures.wait(waiting, 1.0, concurrent.futures.FIRST_COMPLETED)
                    bar.show()
                    for future in done:
                        future.result()
                        bar.add(futures[future].cost)
            except BaseException:
                with self.lock:
                    self.stopped = True  # starts no others
                    for child in self.children:
                        child.send_signal(signal.SIGINT)
                pool.shutdown(cancel_futures=True)
                raise
            finally:
                bar.end()

    def carry_out_one(self, run):
        """Executes a run in an empty folder; the stamp is written when it is complete."""
        shutil.rmtree(run.folder, ignore_errors=True)
        run.folder.mkdir(parents=True)
        stamp = run.stamp()
        for command in run.commands:
            self.execute(list(map(str, command)), run.folder)
        (run.folder / STAMP).write_text(stamp, encoding='utf-8')

    def execute(self, command, folder):
        """Runs a program; its output and processor time are written to log.txt."""
        with open(folder / LOG, 'a', encoding='utf-8') as log:
            log.write(' '.join(command) + '\n')
            log.flush()
            with self.lock:
                if self.stopped:
                    raise RunError('stopped')
                # In its own process group: this process receives Ctrl-C and forwards it.
                child = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                                         start_new_session=True)
                self.children.add(child)
            _, status, usage = os.wait4(child.pid, 0)
            with self.lock:
                child.returncode = os.waitstatus_to_exitcode(status)
                self.children.discard(child)
            log.write(f'{PROCESSOR_TIME}: {usage.ru_utime + usage.ru_stime:.2f} s\n')
        if child.returncode != 0:
            lines = re.split(r'[\r\n]+', (folder / LOG).read_text(encoding='utf-8', errors='replace').strip())
            raise RunError('\n'.join([f'{" ".join(command)}: exit status {child.returncode}', *lines[-5:]]))


def execute_left(runs, processes, force=False):
    """Executes the runs that are not done yet, or all; runs that are given several times are executed once."""
    runs = list({run.folder: run for run in runs}.values())
    left = runs if force else [run for run in runs if not run.is_done()]
    print(f'{len(runs)} runs, {len(runs) - len(left)} of them done before', flush=True)
    try:
        if left:
            Runner(processes).carry_out(left)
    except KeyboardInterrupt:
        print(f'Interrupted: {sum(run.is_done() for run in runs)} of {len(runs)} runs are done and kept; the same '
              'command continues from there.')
        raise


def processor_seconds(folder):
    """Returns the processor time of each command of a run [s]."""
    log = (folder / LOG).read_text(encoding='utf-8', errors='replace')
    return [float(seconds) for seconds in re.findall(rf'^{PROCESSOR_TIME}: ([\d.]+) s$', log, re.MULTILINE)]
