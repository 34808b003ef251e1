# The stages shift G without its sign.
s/{STAGE{in_d_g\[D-1\]}}/{STAGE{1'b0}}/
