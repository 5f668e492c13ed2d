"""Pictures of Q-tables, with their rows explained."""
