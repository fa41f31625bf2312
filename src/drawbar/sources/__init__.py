"""Publications as data: one file each, every number with the place where it is printed."""
