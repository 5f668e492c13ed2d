"""Conversion of other packages' scenes into scenario files."""
