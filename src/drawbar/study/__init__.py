"""Questions asked of measurements and models: identify, compare, reproduce."""
