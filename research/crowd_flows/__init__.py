"""Flows of a crowd in corridors and through doors, beside measurements of people."""
