# Reset does not clear the valid bits of the stages.
s/valid <= 1'b0;/valid <= in_valid;/
