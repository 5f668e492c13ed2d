"""What nodes need that run another program, and whose end is to be the end of the launch."""
