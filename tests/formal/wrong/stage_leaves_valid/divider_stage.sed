# Reset does not clear the valid bits of the stages.
/u_slot (/{n;s/\.reset(reset)/.reset(1'b0)/;}
