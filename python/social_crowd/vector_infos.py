"""Information of many environments in one dict, as Gymnasium's vector environments have it."""
import numpy


def add_info(infos, info, element, count):
    """Adds the information of one of `count` environments: for each key an array, and below `_key` whose it is.

    Values below `final_obs` stay as they are; dicts become dicts of arrays.
    """
    for key, value in info.items():
        if isinstance(value, dict) and key != 'final_obs':
            infos[key] = add_info(infos.get(key, {}), value, element, count)
        else:
            if key not in infos:
                infos[key] = _empty(value, count)
            infos[key][element] = value
        infos.setdefault(f'_{key}', numpy.zeros(count, bool))[element] = True
    return infos


def _empty(value, count):
    if isinstance(value, (bool, int, float, numpy.number, numpy.bool_)):
        return numpy.zeros(count, dtype=type(value))
    return numpy.full(count, None, dtype=object)
