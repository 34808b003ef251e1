// table_proof: what the divider's table holds. There is no clock: a single state with k free is all
// there is.
//
// Properties
//   rounded  for k = 1 to 16 the bits are 2^n / k rounded to nearest, n = SHIFTS: k times them is
//            within half a k of 2^n
//   miss     for every other k they are 0 and miss is 1, which it is for no k of the table
`default_nettype none

module table_proof #(
    parameter integer SHIFTS = 12
) (
    input wire [7:0] k
);
    wire [SHIFTS:0] bits;
    wire            miss;
    reciprocal_rom #(.SHIFTS(SHIFTS)) u_rom (.k(k), .bits(bits), .miss(miss));

    wire        in_table = k >= 8'd1 && k <= 8'd16;
    wire [23:0] power    = 24'd2 << SHIFTS;

    // Twice k times the bits, for each k a product by a constant.
    reg  [23:0] product;
    integer     j;
    always @* begin
        product = 24'd0;
        for (j = 1; j <= 16; j = j + 1)
            if (k == j) product = 2 * j * bits;
    end

    always @* begin
        rounded: assert (!in_table || (product <= power + k && power <= product + k));
        miss_:   assert (miss == !in_table && (in_table || bits == {(SHIFTS + 1){1'b0}}));

        c_rounded: cover (in_table && product > power);
        c_miss:    cover (miss && k == 8'd17);
    end
endmodule

`default_nettype wire
