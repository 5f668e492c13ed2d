"""Texts of results."""
import math

from crowd_experiments.records import Spread

from .measures import left_over, nearest_of


def spread(values, unit='', decimals=1):
    """Returns mean and range over the seeds, such as `30.1 s (29.9-30.4)`. Infinite values are counted apart."""
    values = list(values)
    numbers = Spread.of_numbers(values)
    unit = f' {unit}' if unit else ''
    if math.isnan(numbers.mean):
        return 'never'
    text = f'{numbers.mean:.{decimals}f}{unit}'
    if f'{numbers.low:.{decimals}f}' != f'{numbers.high:.{decimals}f}':
        text += f' ({numbers.low:.{decimals}f}-{numbers.high:.{decimals}f})'
    missing = len(values) - len(numbers.values)
    return text + (f', never in {missing} of {len(values)} seeds' if missing else '')


def counts(values):
    """Returns whole numbers over the seeds, such as `20` or `18-20`."""
    low, high = min(values), max(values)
    return f'{low}' if low == high else f'{low}-{high}'


def arrived(recordings):
    """Returns the number of arrivals, such as `1000 of 1000 arrived`."""
    numbers = [sum(map(math.isfinite, recording.arrivals)) for recording in recordings]
    return f'{counts(numbers)} of {recordings[0].people()} arrived'


def problems(recordings, landmarks):
    """Returns a text about people who did not arrive, by their nearest landmark (points by names), and about contacts;
    empty if there were none in any seed."""
    parts = []
    for seed, recording in enumerate(recordings, 1):
        of_seed = [text for text in (left_over_text(recording, landmarks), contact_text(recording)) if text]
        if of_seed:
            parts.append(f'seed {seed}: {", ".join(of_seed)}')
    return '; '.join(parts)


def left_over_text(recording, landmarks):
    """Returns the number of people who did not arrive, and their places at the end."""
    places, standing = left_over(recording)
    if len(places) == 0:
        return ''
    near = nearest_of(places, list(landmarks.values()))
    at = ', '.join(f'{(near == i).sum()} at {name}' for i, name in enumerate(landmarks) if (near == i).any())
    return f'{len(places)} left ({at}), {standing} of them stand'


def contact_text(recording):
    """Returns the number of people in contact."""
    return f'{recording.touched.sum()} in contact' if recording.touched.any() else ''
