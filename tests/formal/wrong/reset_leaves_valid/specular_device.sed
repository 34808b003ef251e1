# Reset does not clear the valid bit of stage 2.
/u_s2_valid (/{n;s/\.reset(reset)/.reset(1'b0)/;}
