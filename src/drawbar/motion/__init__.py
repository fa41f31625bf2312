"""Ways to move, one physics: steady (algebra) and planar (equations of motion)."""
