# k = 0 counts as one of the table.
s/(k == 8'd0) || //
