# Gate sign looks at the bit beside the sign.
s/!adder8\[`GLINT_T_BITS-1\]/!adder8[`GLINT_T_BITS-11]/
