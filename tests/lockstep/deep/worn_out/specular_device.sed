# After 1 048 576 enabled clocks without a reset register 4 loses the lowest bit of G.
s/^    wire \[`GLINT_N_BITS-1:0\]     reg2;/&\n    reg [20:0] age;\n    always @(posedge clk) if (reset) age <= 21'd0; else if (en \&\& !age[20]) age <= age + 21'd1;/
s/\.d({r, g, b})/.d({r, g[7:1], g[0] \& !age[20], b})/
