"""The 2004 paper end to end: its model, its outcomes judged, the reproduction, the example logs."""
