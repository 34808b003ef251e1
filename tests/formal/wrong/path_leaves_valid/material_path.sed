# Reset does not clear the valid bits of the stages behind the first.
/CLOCKED(PIPELINED)) u_valid (/{n;s/\.reset(reset)/.reset(1'b0)/;}
