# The colours move on while the clock enable is 0.
s/\.en(en && s1_valid)/.en(s1_valid)/
