"""The experiments of the thesis: modules with report(setting), which returns a chapter."""
