# After 65 536 enabled clocks without a reset register 3 loses the lowest bit of R.
s/^    wire \[`GLINT_N_BITS-1:0\]     reg2;/&\n    reg [16:0] age;\n    always @(posedge clk) if (reset) age <= 17'd0; else if (en \&\& !age[16]) age <= age + 17'd1;/
s/\.d({r, g, b})/.d({r[7:1], r[0] \& !age[16], g, b})/
