"""Random worlds with known goals, end to end, as figures."""
