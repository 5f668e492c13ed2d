"""Shared code of the programs that run experiments: running tools, storing results, drawing figures, writing pages."""
