# The table is asked with the k before the input register, which may be a later slot's.
s/u_rom (.k(s0_k)/u_rom (.k(k)/
