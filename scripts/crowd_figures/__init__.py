"""Modules of scripts/draw_figures."""
