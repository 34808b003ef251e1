# The level is cut off, not rounded: the half is not added.
s/ + {{I{1'b0}}, value\[FRACTION-1\]};/ + {{I{1'b0}}, 1'b0 \& value[FRACTION-1]};/
