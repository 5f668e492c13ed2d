"""Errors of this package: those of the C++ module, or the same classes where it was not built."""
try:
    from social_crowd._core import CrowdError, FileError, InputError, ShapeError
except ImportError:
    class CrowdError(Exception):
        """Base class of all errors of this package."""

    class InputError(CrowdError, ValueError):
        """Invalid input; the message says where and what was expected."""

    class FileError(CrowdError, OSError):
        """A file cannot be read or written."""

    class ShapeError(CrowdError, ValueError):
        """A Q-table does not match its target."""

__all__ = ['CrowdError', 'FileError', 'InputError', 'ShapeError']
