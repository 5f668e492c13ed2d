"""People in each frame as CSV: metres in the map, z up."""
import numpy

HEAD = ('time', 'person', 'x', 'y', 'heading', 'hips_z',
        *(f'{side}_{column}' for side in ('left', 'right') for column in ('x', 'y', 'z', 'stands')))


def write(file, people):
    """Writes a row for each person and frame, and returns how many. Feet are ankles; none of people in wheelchairs."""
    count = 0
    with open(file, 'w', encoding='utf-8') as stream:
        stream.write(','.join(HEAD) + '\n')
        for person in people:
            trunk = person.trunk
            columns = [person.times, numpy.full(len(person.times), person.number), *person.places().T, trunk.headings,
                       person.scale * trunk.hips[:, 2]]
            for foot in person.feet:
                columns += [*(person.scale * foot.ankle).T, foot.stands]
            form = ['%.4f', person.name.rpartition('_')[0] + '_%d', *['%.4f'] * 4, *[*['%.4f'] * 3, '%d'] * 2]
            empty = ',' * (len(HEAD) - len(columns))
            numpy.savetxt(stream, numpy.column_stack(columns), ','.join(form[:len(columns)]) + empty)
            count += len(person.times)
    return count
