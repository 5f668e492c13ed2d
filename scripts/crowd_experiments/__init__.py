"""What programs that carry out experiments share: they run the tools, keep results, draw figures and write a page."""
