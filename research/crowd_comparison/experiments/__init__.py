"""The experiments of the comparison: modules with plan(setting) and report(setting)."""
