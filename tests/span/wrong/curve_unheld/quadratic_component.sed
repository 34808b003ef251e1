# The second difference loads with every step.
s/\.en(en && load)/.en(en \&\& (load || step))/
