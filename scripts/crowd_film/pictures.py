"""Writes films: GIF, WebP, and MP4 with the program ffmpeg."""
import itertools
import shutil
import subprocess

import PIL.Image
import numpy
from crowd_drawing.errors import InputError

QUALITY = '20'  # constant rate factor of x264: 0 is lossless, 51 the worst
WHITE, TRANSPARENT = 126, 127  # their numbers in the palette of a GIF, after the other colours
NO_DITHER = 0  # the name differs between versions of PIL
WEBP = {'quality': 80, 'method': 4}


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


def write_gif(file, frames, samples, duration):
    """Writes frames, arrays of RGB bytes, as a GIF that is repeated forever.

    All frames have the colours of `samples`, some of the frames. Pixels that do not change are transparent, which makes
    the file small. Duration: of a frame [ms], a multiple of 10."""
    palette = PIL.Image.fromarray(numpy.vstack(samples)).quantize(WHITE, method=PIL.Image.MEDIANCUT, dither=NO_DITHER)
    colours = palette.getpalette()[:3 * WHITE]
    palette.putpalette(colours + [255] * (3 * 256 - len(colours)))  # white in all further places
    pictures = changes(frames, palette)
    next(pictures).save(file, format='GIF', save_all=True, append_images=pictures, duration=duration, loop=0,
                        disposal=1, transparency=TRANSPARENT, optimize=False)


def changes(frames, palette):
    """Yields pictures with a palette, whose pixels are transparent where they are those of the frame before."""
    before = None
    for frame in frames:
        picture = PIL.Image.fromarray(frame).quantize(palette=palette, dither=NO_DITHER)
        indices = numpy.minimum(numpy.asarray(picture), WHITE)
        indices[(frame == 255).all(axis=2)] = WHITE  # quantize() takes a colour near it
        changed = indices if before is None else numpy.where(indices == before, numpy.uint8(TRANSPARENT), indices)
        result = PIL.Image.fromarray(changed, mode='P')
        result.putpalette(palette.getpalette()[:3 * (TRANSPARENT + 1)])
        before = indices
        yield result


def write_webp(file, frames, _samples, duration):
    """Writes frames, arrays of RGB bytes, as an animated WebP that is repeated forever. Duration: of a frame [ms]."""
    pictures = (PIL.Image.fromarray(frame) for frame in frames)
    next(pictures).save(file, format='WEBP', save_all=True, append_images=list(pictures), duration=duration, loop=0,
                        **WEBP)
