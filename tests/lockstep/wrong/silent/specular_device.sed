# The last stage never says that a result is valid.
s/out_valid <= s[0-9]_valid/out_valid <= {LANES{1'b0}}/
