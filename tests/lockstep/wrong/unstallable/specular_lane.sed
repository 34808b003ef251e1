# Register 1 loads while the clock enable is 0.
s/\.en(en && in_valid)/.en(in_valid)/
