"""Studies: programs that run experiments, and write pages with tables and figures."""
