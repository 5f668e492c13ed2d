"""Compares the learned crowds with each other, and with ORCA and social force."""
