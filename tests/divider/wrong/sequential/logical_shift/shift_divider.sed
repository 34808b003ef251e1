# The shift register forgets the sign: 0 comes in from the left, whatever the difference.
s/= {shift_rg\[WIDTH-1\], shift_rg/= {1'b0, shift_rg/
