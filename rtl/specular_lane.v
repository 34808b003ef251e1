// specular_lane: the blocks of figure 3.1 that exist once per cosine.
//
// Function    W = t^2 if comparator 11 passes it, else 0;  t = sigma (cos - 1) + 1
//             out_r, out_g, out_b = W times R, G, B
// Blocks      register 1, adders 6 and 8, multipliers 7, 10, 13, 14, 15, comparator 11, keys 12
// Formats     cos, reg1, rom9, W  U1.18    rom33 (sigma)  U9.13    adder6  S1.18
//             mul7, adder8 (t)    S10.18   colours        U8.0
//             the i integer digits of S<i>.<f> include the sign.
// Rounding    half up, at multipliers 7, 10, 13, 14, 15; nowhere else.
// Saturation  register 1 loads 1.0 for any code above 1.0; GATE drawn: the square is at most 1.0.
// Latency     1 clock (PIPELINED = 0) or 4 (PIPELINED = 1), from the edge that loads register 1 to
//             the one after which the result is out, both counted. One cosine per clock.
// Reset       synchronous, active high, all registers 0, regardless of en. en = 0 holds them all.
// Handshake   none here: specular_device carries the valid bits alongside the lanes.
// Parameters  GATE 0 cosine: comparator 11 compares register 1 with ROM 9, a cosine limit
//                  1 sign:   the sign of adder 8 decides, ROM 9 is unused
//                  2 drawn:  comparator 11 compares the square with ROM 9, a W limit
//             PIPELINED 1 (default) or 0
//             LEAN 0 (default): multipliers 7 and 10 as drawn, of full width
//                  1: of 23 x 18 and 18 x 18 bits (lean_product, lean_square). All registers and
//                  outputs are the same; mul10 is another where comparator 11 does not pass it.
//             W_DROP 0 (default), or places of W that are rounded off for s3_keys12, half up
// Example     n = 80, r = 255, g = 190, b = 110, cos = 259523 (0.99): reg1 = 259523,
//             rom33 = 221184 (27), rom9 = 252435 (0.963), adder6 = -2621 (-0.01),
//             mul7 = -70767 (-0.27), adder8 = 191377 (0.73), cmp11 = 1, mul10 = 139714 (0.533),
//             keys12 = 139714, mul13 = 136, mul14 = 101, mul15 = 59
`default_nettype none
`include "glint_formats.vh"

module specular_lane #(
    parameter integer GATE      = `GLINT_GATE_COSINE,
    parameter integer PIPELINED = 1,
    parameter integer LEAN      = 0,
    parameter integer W_DROP    = 0
) (
    input  wire                        clk,
    input  wire                        reset,
    input  wire                        en,
    input  wire                        in_valid, // register 1 loads
    input  wire [`GLINT_COS_BITS-1:0]  cos,      // information input 32

    // Material, delayed by the device to the stage that reads it.
    input  wire [`GLINT_SIGMA_BITS-1:0] rom33,
    input  wire [`GLINT_COS_BITS-1:0]   rom9,
    input  wire [`GLINT_COS_BITS-1:0]   s2_rom9,
    input  wire [`GLINT_COLOR_BITS-1:0] s3_reg3,
    input  wire [`GLINT_COLOR_BITS-1:0] s3_reg4,
    input  wire [`GLINT_COLOR_BITS-1:0] s3_reg5,

    output wire [`GLINT_W_FRAC_BITS-W_DROP:0] out_w,
    output wire [`GLINT_COLOR_BITS-1:0] out_r,
    output wire [`GLINT_COLOR_BITS-1:0] out_g,
    output wire [`GLINT_COLOR_BITS-1:0] out_b
);
    localparam DRAWN = (GATE == `GLINT_GATE_DRAWN);

    // Stage 1: register 1; adder 6, multiplier 7 and adder 8; comparator 11 unless it waits for the
    // square.
    localparam [`GLINT_COS_BITS-1:0] COS_ONE = {1'b1, {`GLINT_COS_FRAC_BITS{1'b0}}};

    wire [`GLINT_COS_BITS-1:0] reg1;
    stage_register #(.WIDTH(`GLINT_COS_BITS)) u_reg1 (
        .clk(clk), .reset(reset), .en(en && in_valid),
        .d((cos > COS_ONE) ? COS_ONE : cos), .q(reg1));

    // All ones on the integer digit is -1 there; the fraction bypasses the adder. The adder is
    // just an inverter, so it needs no stage of its own before the multiplier.
    wire digit6 = reg1[`GLINT_COS_FRAC_BITS] + 1'b1;
    wire signed [`GLINT_ADDER6_BITS-1:0] adder6 = {digit6, reg1[`GLINT_COS_FRAC_BITS-1:0]};

    localparam SUM7_BITS = `GLINT_T_BITS + `GLINT_SIGMA_FRAC_BITS;
    localparam signed [SUM7_BITS-1:0] HALF7 = {{`GLINT_T_BITS{1'b0}}, 1'b1,
                                               {(`GLINT_SIGMA_FRAC_BITS - 1){1'b0}}};

    wire signed [`GLINT_SIGMA_BITS:0] sigma7 = {1'b0, rom33};
    wire signed [SUM7_BITS-1:0]       sum7;
    wire signed [`GLINT_T_BITS-1:0]   mul7;
    wire [`GLINT_SIGMA_FRAC_BITS-1:0] mul7_unused;
    assign {mul7, mul7_unused} = sum7;
    generate
        if (LEAN != 0) begin : g_product
            wire signed [SUM7_BITS-1:0] product7;
            wire                        operands7_unused = &{1'b0, sigma7, adder6};
            lean_product u_product (.sigma(rom33), .cos(reg1), .product(product7));
            assign sum7 = product7 + HALF7;
        end else begin : g_product
            assign sum7 = sigma7 * adder6 + HALF7;
        end
    endgenerate

    // Carry-in 1 at the integer digits is +1; the fraction bypasses the adder.
    wire signed [`GLINT_T_BITS-1:0] adder8 = {
        mul7[`GLINT_T_BITS-1:`GLINT_T_FRAC_BITS] + {{(`GLINT_T_INT_BITS - 1){1'b0}}, 1'b1},
        mul7[`GLINT_T_FRAC_BITS-1:0]};

    wire cmp11;

    // Stage 2: multiplier 10 and key block 12.
    localparam MUL10_BITS = (DRAWN && LEAN == 0) ? `GLINT_W_DRAWN_BITS : `GLINT_W_BITS;
    wire signed [`GLINT_T_BITS-1:0] s2_adder8;
    wire                            s2_cmp11;
    wire [MUL10_BITS-1:0]           mul10;
    wire [`GLINT_W_BITS-1:0]        sat10;

    stage_register #(.WIDTH(`GLINT_T_BITS), .CLOCKED(PIPELINED)) u_s2_adder8 (
        .clk(clk), .reset(reset), .en(en), .d(adder8), .q(s2_adder8));
    stage_register #(.WIDTH(1), .CLOCKED(PIPELINED)) u_s2_cmp11 (
        .clk(clk), .reset(reset), .en(en), .d(cmp11 && !DRAWN), .q(s2_cmp11));

    generate
        if (GATE == `GLINT_GATE_DRAWN && LEAN == 0) begin : g_square
            localparam SUM10_BITS = `GLINT_W_DRAWN_BITS + `GLINT_W_FRAC_BITS;
            localparam signed [SUM10_BITS-1:0] HALF10 = {
                {`GLINT_W_DRAWN_BITS{1'b0}}, 1'b1, {(`GLINT_W_FRAC_BITS - 1){1'b0}}};
            localparam [`GLINT_W_DRAWN_BITS-1:0] W_ONE = {
                {(`GLINT_W_DRAWN_INT_BITS - 1){1'b0}}, 1'b1, {`GLINT_W_FRAC_BITS{1'b0}}};

            wire signed [SUM10_BITS-1:0]  sum10 = s2_adder8 * s2_adder8 + HALF10;
            wire [`GLINT_W_FRAC_BITS-1:0] mul10_unused;
            assign {mul10, mul10_unused} = sum10;

            assign sat10 = (mul10 > W_ONE) ? W_ONE[`GLINT_W_BITS-1:0] : mul10[`GLINT_W_BITS-1:0];
            assign cmp11 = mul10 >= {{(`GLINT_W_DRAWN_INT_BITS - 1){1'b0}}, s2_rom9};
        end else begin : g_square
            // Where the gate passes, t is in 0..1, or LEAN has -1..1: W's digits are enough.
            localparam SUM10_BITS = 2 * `GLINT_W_BITS;
            localparam [SUM10_BITS-1:0] HALF10 = {
                {(SUM10_BITS - `GLINT_W_FRAC_BITS){1'b0}}, 1'b1, {(`GLINT_W_FRAC_BITS - 1){1'b0}}};

            wire [SUM10_BITS-1:0]         sum10;
            wire                          mul10_high_unused;
            wire [`GLINT_W_FRAC_BITS-1:0] mul10_low_unused;
            assign {mul10_high_unused, mul10, mul10_low_unused} = sum10;

            if (LEAN != 0) begin : g_lean
                wire [SUM10_BITS-1:0] square10;
                lean_square u_square (.t(s2_adder8[`GLINT_W_BITS:0]), .square(square10));
                assign sum10 = square10 + HALF10;
            end else begin : g_lean
                wire [`GLINT_W_BITS-1:0] t10 = s2_adder8[`GLINT_W_BITS-1:0];
                assign sum10 = t10 * t10 + HALF10;
            end

            if (GATE == `GLINT_GATE_DRAWN) begin : g_saturate
                // t is at most 1; below -1 its square is above 1.
                wire over10 = s2_adder8[`GLINT_T_BITS-1]
                              && !(&s2_adder8[`GLINT_T_BITS-2:`GLINT_W_FRAC_BITS]);
                assign sat10 = over10 ? {1'b1, {`GLINT_W_FRAC_BITS{1'b0}}} : mul10;
            end else begin : g_saturate
                assign sat10 = mul10;
            end

            if (GATE == `GLINT_GATE_DRAWN) begin : g_compare
                assign cmp11 = sat10 >= s2_rom9;
            end else if (GATE == `GLINT_GATE_SIGN) begin : g_compare
                assign cmp11 = !adder8[`GLINT_T_BITS-1];
            end else begin : g_compare
                assign cmp11 = reg1 >= rom9;
            end
        end
    endgenerate

    wire gate_unused = &{1'b0, reg1, rom9, s2_rom9, s2_adder8}; // no gate reads all of them

    wire                     pass12 = DRAWN ? cmp11 : s2_cmp11;
    wire [`GLINT_W_BITS-1:0] keys12 = pass12 ? sat10 : {`GLINT_W_BITS{1'b0}};

    localparam FRAC = `GLINT_W_FRAC_BITS - W_DROP;
    wire [FRAC:0] rounded12;
    w_rounder #(.W_DROP(W_DROP)) u_rounded12 (.w(keys12), .rounded(rounded12));

    // Stage 3: multipliers 13, 14, 15.
    wire [FRAC:0]                s3_keys12;
    wire [`GLINT_COLOR_BITS-1:0] mul13;
    wire [`GLINT_COLOR_BITS-1:0] mul14;
    wire [`GLINT_COLOR_BITS-1:0] mul15;
    stage_register #(.WIDTH(1 + FRAC), .CLOCKED(PIPELINED)) u_s3_keys12 (
        .clk(clk), .reset(reset), .en(en), .d(rounded12), .q(s3_keys12));

    color_multiplier #(.W_FRAC_BITS(FRAC)) u_mul13 (
        .w(s3_keys12), .color(s3_reg3), .product(mul13));
    color_multiplier #(.W_FRAC_BITS(FRAC)) u_mul14 (
        .w(s3_keys12), .color(s3_reg4), .product(mul14));
    color_multiplier #(.W_FRAC_BITS(FRAC)) u_mul15 (
        .w(s3_keys12), .color(s3_reg5), .product(mul15));

    // Stage 4: the outputs.
    stage_register #(.WIDTH(1 + FRAC), .CLOCKED(PIPELINED)) u_out_w (
        .clk(clk), .reset(reset), .en(en), .d(s3_keys12), .q(out_w));
    stage_register #(.WIDTH(3 * `GLINT_COLOR_BITS), .CLOCKED(PIPELINED)) u_out_rgb (
        .clk(clk), .reset(reset), .en(en), .d({mul13, mul14, mul15}), .q({out_r, out_g, out_b}));
endmodule

`default_nettype wire
