"""Python interface of the crowd simulator.

Without ROS: Crowd, Env, VecEnv, evaluate, train, QTable and Scenario (docs/python.md). Through ROS: crowd_env.CrowdEnv;
messages and services are in social_crowd.msg and social_crowd.srv.
"""
import importlib

# What each module gives; they are imported when they are used, so that messages need neither NumPy nor the C++ module.
_MODULES = {
    '_core': ('CrowdError', 'FileError', 'InputError', 'QTable', 'Scenario', 'ShapeError', 'Training'),
    'crowd': ('Crowd', 'Evaluation', 'evaluate', 'train'),
    'env': ('Env',),
    'observations': ('Observation',),
    'rewards': ('each_robot', 'progress_reward'),
    'sb3': ('SB3VecEnv',),
    'vec_env': ('VecEnv',),
}
_HOME = {name: module for module, names in _MODULES.items() for name in names}
__all__ = sorted(_HOME)


def __getattr__(name):
    if name not in _HOME:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    try:
        module = importlib.import_module(f'{__name__}.{_HOME[name]}')
    except ModuleNotFoundError as error:
        if error.name != f'{__name__}._core':
            raise
        raise ImportError(f'{__name__}.{name} needs the C++ module, which was built without: install pybind11-dev and '
                          'python3-dev, and build the package again') from error
    return getattr(module, name)


def __dir__():
    return sorted(set(globals()) | set(__all__))
