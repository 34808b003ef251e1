# out_of_table is never raised.
s/out_of_table <= rom_miss;/out_of_table <= 1'b0;/
