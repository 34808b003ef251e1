# After 64 stalls in a row stage 1 forgets its points.
s/^    reg \[`GLINT_N_BITS-1:0\]     reg2;/&\n    reg [6:0] waited;\n    always @(posedge clk) if (reset || en) waited <= 7'd0; else if (!waited[6]) waited <= waited + 7'd1;/
s/else if (en) s1_valid <= in_valid;/&\n        else if (waited[6]) s1_valid <= {LANES{1'b0}};/
