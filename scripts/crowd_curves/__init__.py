"""Learning curves: results by episode, over several runs."""
