"""The benchmark of robots among people."""
