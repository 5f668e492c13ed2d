"""Runs as animated figures: glTF, BVH and CSV."""
