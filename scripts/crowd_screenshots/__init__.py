"""Modules of scripts/screenshots."""
