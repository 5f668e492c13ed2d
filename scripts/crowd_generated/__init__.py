"""What scripts/generate writes."""
