"""Recorded crowds: formats of files, conversions, positions between ticks, replay."""
