"""An instruction carried out: `executor` grounds it, plans on a `stage`, moves, checks, and writes a `report`."""
