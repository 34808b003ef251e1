# The stages forget that k was beyond the table.
s/miss  <= in_miss;/miss  <= 1'b0;/
