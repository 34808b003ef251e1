# The stages move while the clock enable is 0.
s/\.en(en)/.en(1'b1)/
