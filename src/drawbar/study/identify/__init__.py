"""From logs to parameters: fits that say how sure they are and what speaks against them."""
