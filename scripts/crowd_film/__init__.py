"""Films of scenarios and of recorded crowds, without a display."""
