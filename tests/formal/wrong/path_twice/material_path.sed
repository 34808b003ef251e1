# A result stays valid: it is given again and again.
s/\.d(valids\[STAGES\*LANES +: LANES\])/.d(valids[STAGES*LANES +: LANES] | out_valid)/
