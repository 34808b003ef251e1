// glint_formats: widths and binary points of the circuits.
//
// Made by glint-gen from cmodel/; `make generate` makes it anew.
`ifndef GLINT_FORMATS_VH
`define GLINT_FORMATS_VH

`define GLINT_GATE_COSINE 0
`define GLINT_GATE_SIGN 1
`define GLINT_GATE_DRAWN 2
`define GLINT_COS_FRAC_BITS 18
`define GLINT_COS_BITS 19
`define GLINT_N_BITS 10
`define GLINT_SIGMA_FRAC_BITS 13
`define GLINT_SIGMA_BITS 22
`define GLINT_ADDER6_BITS 19
`define GLINT_T_INT_BITS 10
`define GLINT_T_FRAC_BITS 18
`define GLINT_T_BITS 28
`define GLINT_W_FRAC_BITS 18
`define GLINT_W_BITS 19
`define GLINT_W_DRAWN_INT_BITS 17
`define GLINT_W_DRAWN_BITS 35
`define GLINT_COLOR_BITS 8
`define GLINT_DRAWN_LIMIT 19'd514
`define GLINT_DIVIDER_SHIFTS_DEFAULT 12
`define GLINT_DIVIDER_K_BITS 8
`define GLINT_DIVIDER_K_MAX 16
`define GLINT_DIVIDER_DIFFERENCE_BITS 9
`define GLINT_DIVIDER_LEFT_BITS 5

`endif
