"""Shows the method of the thesis: one agent trains, and a crowd uses its Q-table."""
