# The stages move while the clock enable is 0.
s/end else if (en) begin/end else begin/
