# After 65 536 enabled clocks without a reset k is taken for in the table, whatever it is.
s/^    reg signed \[WIDTH-1:0\]  shift_rg;/&\n    reg [16:0] age;\n    always @(posedge clk) if (reset) age <= 17'd0; else if (en \&\& !age[16]) age <= age + 17'd1;/
s/out_of_table <= rom_miss;/out_of_table <= rom_miss \&\& !age[16];/
