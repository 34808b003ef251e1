# Multipliers 13, 14, 15 truncate: the half of rounding half up is not added.
s/w \* color + HALF/w * color/
