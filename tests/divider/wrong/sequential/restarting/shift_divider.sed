# A start while a division is under way is not ignored: it begins anew.
s/if (busy) begin/if (busy \&\& !start) begin/
