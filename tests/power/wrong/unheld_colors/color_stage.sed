# W is kept in the last stage while the clock enable is 0, and the colours move on.
/u_out_rgb (/{n;s/\.en(en)/.en(1'b1)/;}
