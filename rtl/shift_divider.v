// shift_divider: the shift-accumulate divider of figure 2.13 (thesis section 2.4).
//
// Function    quotient = difference * (i0 + i1/2 + i2/4 + ... + in/2^n), n = SHIFTS, the bits ij
//             being those of 2^n/k rounded to nearest: about difference / k (2.18). No bit that is
//             shifted out is lost, so the quotient is the exact sum.
// Blocks      shift register shift_rg, accumulating register acc_rg and its adder sum, table
//             rom_bits (reciprocal_rom); bits_rg gives the adder one bit per clock: it adds where
//             ij = 1.
// Formats     difference S9.0, -255..255;  k U8.0;  quotient, shift_rg, acc_rg S9.n
// Rounding    none here: the rounding is in the table.
// Latency     SHIFTS + 1 clocks from the edge that accepts start to the one after which done is 1,
//             both counted. Throughput: one division every SHIFTS + 1 clocks.
// Handshake   start is accepted at an enabled edge while busy = 0. done is 1 for one enabled clock;
//             quotient and out_of_table hold from then until the next accepted start. A start while
//             busy = 1 is ignored. start and done may coincide.
//             k = 0 or above GLINT_DIVIDER_K_MAX: out_of_table = 1 and quotient = 0.
// Reset       synchronous, active high, clears everything, regardless of en. en = 0 freezes all.
// Parameters  SHIFTS 6..16
// Example     SHIFTS = 12, k = 7, difference = 255: rom_bits = 585 (0.001001001001), and 13 clocks
//             on done = 1, quotient = 149175 (36.42)
`default_nettype none
`include "glint_formats.vh"

module shift_divider #(
    parameter integer SHIFTS = `GLINT_DIVIDER_SHIFTS_DEFAULT
) (
    input  wire                                                    clk,
    input  wire                                                    reset,
    input  wire                                                    en,
    input  wire                                                    start,
    input  wire signed [`GLINT_DIVIDER_DIFFERENCE_BITS-1:0]        difference,
    input  wire        [`GLINT_DIVIDER_K_BITS-1:0]                 k,
    output reg                                                     busy,
    output reg                                                     done,
    output wire signed [`GLINT_DIVIDER_DIFFERENCE_BITS+SHIFTS-1:0] quotient,
    output reg                                                     out_of_table
);
    localparam WIDTH = `GLINT_DIVIDER_DIFFERENCE_BITS + SHIFTS;
    localparam LEFT  = `GLINT_DIVIDER_LEFT_BITS;
    localparam [LEFT-1:0] LAST = {{(LEFT - 1){1'b0}}, 1'b1};

    // The table: i0 is its highest bit.
    wire [SHIFTS:0] rom_bits;
    wire            rom_miss;
    reciprocal_rom #(.SHIFTS(SHIFTS)) u_rom (.k(k), .bits(rom_bits), .miss(rom_miss));

    reg signed [WIDTH-1:0]  shift_rg;
    reg signed [WIDTH-1:0]  acc_rg;
    reg        [SHIFTS-1:0] bits_rg; // remaining bits, next one highest
    reg        [LEFT-1:0]   left;    // how many

    wire signed [WIDTH-1:0] loaded  = {difference, {SHIFTS{1'b0}}};
    wire signed [WIDTH-1:0] shifted = {shift_rg[WIDTH-1], shift_rg[WIDTH-1:1]};
    wire signed [WIDTH-1:0] term    = bits_rg[SHIFTS-1] ? shifted : {WIDTH{1'b0}};
    wire signed [WIDTH-1:0] sum     = acc_rg + term;

    assign quotient = acc_rg;

    always @(posedge clk)
        if (reset) begin
            shift_rg     <= {WIDTH{1'b0}};
            acc_rg       <= {WIDTH{1'b0}};
            bits_rg      <= {SHIFTS{1'b0}};
            left         <= {LEFT{1'b0}};
            busy         <= 1'b0;
            done         <= 1'b0;
            out_of_table <= 1'b0;
        end else if (en) begin
            if (busy) begin
                shift_rg <= shifted;
                acc_rg   <= sum;
                bits_rg  <= {bits_rg[SHIFTS-2:0], 1'b0};
                left     <= left - LAST;
                busy     <= (left != LAST);
                done     <= (left == LAST);
            end else begin
                done <= 1'b0;
                if (start) begin
                    shift_rg     <= loaded;
                    acc_rg       <= rom_bits[SHIFTS] ? loaded : {WIDTH{1'b0}};
                    bits_rg      <= rom_bits[SHIFTS-1:0];
                    left         <= SHIFTS[LEFT-1:0];
                    busy         <= 1'b1;
                    out_of_table <= rom_miss;
                end
            end
        end
endmodule

`default_nettype wire
