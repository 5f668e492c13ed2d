"""Drawings of the package's own maps."""
