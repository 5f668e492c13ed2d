"""Reports: one page with the results of runs, side by side."""
