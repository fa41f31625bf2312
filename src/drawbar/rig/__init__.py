"""The rig: runs of the virtual one, logs of a real one, in one format."""
