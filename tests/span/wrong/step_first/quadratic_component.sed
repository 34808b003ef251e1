# A step goes before a load.
s/load ? {start, first} : {next_value, next_slope}/step ? {next_value, next_slope} : {start, first}/
