"""What is written from the list of metrics."""
