# Reset leaves the quotient of before.
s/acc_rg       <= {WIDTH{1'b0}};/acc_rg       <= acc_rg;/
