"""Standard tests of pedestrian models: generated scenarios, measures, a table and a page with the results."""
