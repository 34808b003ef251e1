# After 64 stalls in a row stage 1 forgets its points.
s/^    wire \[`GLINT_N_BITS-1:0\]     reg2;/&\n    reg [6:0] waited;\n    always @(posedge clk) if (reset || en) waited <= 7'd0; else if (!waited[6]) waited <= waited + 7'd1;/
/u_s1_valid (/{n;s/\.en(en), \.d(in_valid)/.en(en || waited[6]), .d(en ? in_valid : {LANES{1'b0}})/;}
