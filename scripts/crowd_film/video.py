"""Writes films as MP4, with the program ffmpeg."""
import itertools
import shutil
import subprocess

from crowd_drawing.errors import InputError

QUALITY = '20'  # constant rate factor of x264: 0 is lossless, 51 the worst


def need_ffmpeg():
    """Returns the program ffmpeg. Raises InputError if it is not installed."""
    program = shutil.which('ffmpeg')
    if program is None:
        raise InputError('ffmpeg is not installed, which MP4 needs; install it, or give --output a name with .gif or '
                         '.webp')
    return program


def write_mp4(file, frames, _samples, duration):
    """Writes frames, arrays of RGB bytes with even sides, as H.264 in MP4. Duration: of a frame [ms]."""
    frames = iter(frames)
    first = next(frames)
    height, width, _ = first.shape
    command = [need_ffmpeg(), '-loglevel', 'error', '-y', '-f', 'rawvideo', '-pix_fmt', 'rgb24', '-s',
               f'{width}x{height}', '-framerate', f'1000/{duration}', '-i', '-', '-c:v', 'libx264', '-crf', QUALITY,
               '-pix_fmt', 'yuv420p', '-movflags', '+faststart', '-f', 'mp4', str(file)]
    ffmpeg = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    try:
        for frame in itertools.chain([first], frames):  # memory holds one frame, not the film
            ffmpeg.stdin.write(frame.tobytes())
    except BrokenPipeError:
        pass  # ffmpeg has failed; its message follows
    except BaseException:
        ffmpeg.kill()
        ffmpeg.communicate()
        raise
    _, message = ffmpeg.communicate()
    if ffmpeg.returncode != 0:
        raise InputError(f"ffmpeg: {message.decode(errors='replace').strip()}")
