# The stages of a lane move while the clock enable is 0.
/CLOCKED/{n;s/\.en(en)/.en(1'b1)/;}
