# The stages forget that k was beyond the table.
s/{in_valid, in_miss, in_bits}/{in_valid, 1'b0, in_bits}/
