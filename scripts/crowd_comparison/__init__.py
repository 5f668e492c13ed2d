"""Compares the learned crowds with each other and with the field's models."""
