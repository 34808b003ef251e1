// power_roms_proof: what the power device's ROMs hold. There is no clock: a single state with the
// address free is all there is.
//
// Properties
//   rising   ROM 9 never falls with x, and begins within a code of 1/ln 2 = 1.4427
//   falling  ROM 33 never rises with the fraction of v; its first word is 1.0, and its last at
//            least half of that, which is where the next shift begins
//   halves   each word of ROM 33 squared is, with the power of two that an even address has, that
//            of twice the fraction: 2^-f 2^-f = 2^-2f within what rounding may do
//
// So with power_proof's value, W never rises with x: x and g(x) do not fall, nor do their product
// with n, what is cut off or rounded of it, and the limit of comparator 11; and 2^-v never rises,
// within one shift by falling, and from one to the next as the last word is at least half the
// first.
`default_nettype none

module power_roms_proof #(
    parameter integer TABLE_BITS = 8,
    parameter integer W_BITS     = 2 * TABLE_BITS - 3
) (
    input wire [TABLE_BITS-1:0] address
);
    localparam [W_BITS-1:0]     ONE   = {1'b1, {(W_BITS - 1){1'b0}}};
    localparam [TABLE_BITS-1:0] LAST  = {TABLE_BITS{1'b1}};
    localparam integer          FIRST = TABLE_BITS == 8 ? 369 : 738; // 1/ln 2 in codes

    wire [TABLE_BITS-1:0] next  = address + 1'b1;
    wire [TABLE_BITS-1:0] twice = address << 1;
    wire [TABLE_BITS+3:0] g, next_g, first_g;
    wire [W_BITS-1:0]     power, next_power, first_power, last_power, twice_power;
    power_log_rom #(.TABLE_BITS(TABLE_BITS)) u_rom9 (.address(address), .g(g));
    power_log_rom #(.TABLE_BITS(TABLE_BITS)) u_rom9_next (.address(next), .g(next_g));
    power_log_rom #(.TABLE_BITS(TABLE_BITS)) u_rom9_first (
        .address({TABLE_BITS{1'b0}}), .g(first_g));
    power_exp_rom #(.TABLE_BITS(TABLE_BITS)) u_rom33 (.address(address), .power(power));
    power_exp_rom #(.TABLE_BITS(TABLE_BITS)) u_rom33_next (.address(next), .power(next_power));
    power_exp_rom #(.TABLE_BITS(TABLE_BITS)) u_rom33_first (
        .address({TABLE_BITS{1'b0}}), .power(first_power));
    power_exp_rom #(.TABLE_BITS(TABLE_BITS)) u_rom33_last (.address(LAST), .power(last_power));
    power_exp_rom #(.TABLE_BITS(TABLE_BITS)) u_rom33_twice (.address(twice), .power(twice_power));

    // The square of a word p + e, e at most half a code: p^2 + 2pe + e^2, so within p + 1 codes of
    // ONE of p^2; and the other word within half of one, or half of that where it is shifted.
    wire                upper  = address[TABLE_BITS-1];
    wire [2*W_BITS:0]   square = power * power;
    wire [2*W_BITS:0]   other  = upper ? twice_power << (W_BITS - 2) : twice_power << (W_BITS - 1);
    wire [2*W_BITS:0]   slack  = power + 1 + (ONE >> (upper ? 2 : 1));

    always @* begin
        rising:        assert (address == LAST || g <= next_g);
        rising_first:  assert (first_g == FIRST || first_g == FIRST + 1);
        falling:       assert (address == LAST || power >= next_power);
        falling_first: assert (first_power == ONE);
        falling_last:  assert (2 * last_power >= ONE);
        halves:        assert (square <= other + slack && other <= square + slack);

        c_rising:  cover (g < next_g && address == 100);
        c_falling: cover (power > next_power && address == 100);
        c_halves:  cover (square != other && address == LAST);
    end
endmodule

`default_nettype wire
