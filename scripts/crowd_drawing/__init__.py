"""Drawings of scenes and of recorded paths."""
