"""Drawings of scenes and of the paths that agents walked in them."""
