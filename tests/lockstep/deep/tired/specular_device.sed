# After 65 536 enabled clocks without a reset register 3 loses the lowest bit of R.
s/^    reg \[`GLINT_N_BITS-1:0\]     reg2;/&\n    reg [16:0] age;\n    always @(posedge clk) if (reset) age <= 17'd0; else if (en \&\& !age[16]) age <= age + 17'd1;/
s/reg3 <= r;/reg3 <= r \& {7'h7f, !age[16]};/
