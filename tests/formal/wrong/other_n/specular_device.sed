# ROM 33 does not see the lowest bit of register 2.
s/u_rom33 (.n(reg2)/u_rom33 (.n({reg2[`GLINT_N_BITS-1:1], 1'b0})/
