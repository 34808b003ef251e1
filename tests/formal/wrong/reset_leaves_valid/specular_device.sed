# Reset does not clear the valid bit of stage 2.
s/s2_valid  <= {LANES{1.b0}};/s2_valid  <= s1_valid;/
