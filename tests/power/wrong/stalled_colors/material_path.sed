# Registers 3, 4 and 5 load while the clock enable is 0.
s/\.en(en && rgb_we)/.en(rgb_we)/
