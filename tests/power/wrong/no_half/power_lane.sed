# Multiplier 10 truncates: the half of rounding half up is not added.
s/s2_mul7 \* s2_rom9 + HALF10/s2_mul7 * s2_rom9/
