# An input straight behind another is lost.
s/\.d(in_valid)/.d(in_valid \&\& !s0_valid)/
