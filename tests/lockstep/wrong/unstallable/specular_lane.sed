# Register 1 loads while the clock enable is 0.
s/else if (en && in_valid) reg1/else if (in_valid)       reg1/
