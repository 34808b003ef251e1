# An input straight behind another is lost.
s/s0_valid <= in_valid;/s0_valid <= in_valid \&\& !s0_valid;/
