// power_proof: lane LANE of power_device, any setting. The prover chooses all inputs at each clock,
// including reset and en; nothing is claimed before the first reset.
//
// Properties
//   uninvited, in_order, once, frozen   those of module flow; the data of a slot is 1 - cos, n and
//                                       the colour that apply to it
//   value   out_w, out_r, out_g, out_b of the slot at the output are those of the formula
//           (power_formula.v) for its cosine, n and colour, with what the ROMs gave for them. The
//           ROMs have the slot's addresses at every clock.
//
// The ROMs are free (free_power_roms.v).
`default_nettype none

module power_proof #(
    parameter integer TABLE_BITS = 8,
    parameter integer PIPELINED  = 1,
    parameter integer LANES      = 1,
    parameter integer LANE       = 0,
    parameter integer W_BITS     = 2 * TABLE_BITS - 3
) (
    input wire                clk,
    input wire                reset,
    input wire                en,
    input wire                n_we,
    input wire [9:0]          n,
    input wire                rgb_we,
    input wire [7:0]          r,
    input wire [7:0]          g,
    input wire [7:0]          b,
    input wire [LANES-1:0]    in_valid,
    input wire [LANES*19-1:0] cos
);
    wire [LANES-1:0]        out_valid;
    wire [LANES*W_BITS-1:0] out_w;
    wire [LANES*8-1:0]      out_r, out_g, out_b;
    power_device #(.ACCURACY(TABLE_BITS - 8), .PIPELINED(PIPELINED), .LANES(LANES)) dut (
        .clk(clk), .reset(reset), .en(en), .n_we(n_we), .n(n), .rgb_we(rgb_we), .r(r), .g(g), .b(b),
        .in_valid(in_valid), .cos(cos), .out_valid(out_valid), .out_w(out_w),
        .out_r(out_r), .out_g(out_g), .out_b(out_b));

    reg started = 1'b0;
    always @(posedge clk) started <= started || reset;

    // The device's own signals: Yosys connects a wire marked hierconn to the one of that name.
    (* hierconn *) wire [9:0]       \dut.path.reg2 ;
    (* hierconn *) wire [7:0]       \dut.path.reg3 , \dut.path.reg4 , \dut.path.reg5 ;
    (* hierconn *) wire [LANES-1:0] \dut.path.valid ;

    wire [3:0]      valids; // of stages 1 to 4
    wire [4*24-1:0] rgbs;
    assign valids[0]  = \dut.path.valid [LANE];
    assign rgbs[23:0] = {\dut.path.reg3 , \dut.path.reg4 , \dut.path.reg5 };

    genvar i;
    generate
        for (i = 2; i <= 4; i = i + 1) begin : \dut.path.stage
            (* hierconn *) wire [LANES-1:0] s_valid;
            (* hierconn *) wire [7:0]       s_reg3, s_reg4, s_reg5;
            assign valids[i-1]         = s_valid[LANE];
            assign rgbs[(i-1)*24 +: 24] = {s_reg3, s_reg4, s_reg5};
        end

        for (i = LANE; i <= LANE; i = i + 1) begin : \dut.lane
            (* hierconn *) wire [17:0]             \u.reg1 ;
            (* hierconn *) wire [TABLE_BITS-1:0]   \u.u_rom9.address , \u.u_rom33.address ;
            (* hierconn *) wire [TABLE_BITS+3:0]   \u.rom9 , \u.s2_rom9 , \u.s3_mul10 ;
            (* hierconn *) wire [15:0]             \u.s2_mul7 ;
            (* hierconn *) wire                    \u.s2_over7 , \u.s3_cmp11 ;
            (* hierconn *) wire [2*TABLE_BITS-4:0] \u.rom33 , \u.colors.w ;

            power_lane_proof #(.TABLE_BITS(TABLE_BITS), .PIPELINED(PIPELINED)) u_proof (
                .clk(clk), .reset(reset), .en(en), .started(started),
                .n_we(n_we), .n(n), .rgb_we(rgb_we), .rgb({r, g, b}),
                .in_valid(in_valid[i]), .cos(cos[i*19 +: 19]),
                .reg1(\u.reg1 ), .reg2(\dut.path.reg2 ), .rgbs(rgbs), .valids(valids),
                .address9(\u.u_rom9.address ), .rom9(\u.rom9 ),
                .address33(\u.u_rom33.address ), .rom33(\u.rom33 ),
                .s2_over7(\u.s2_over7 ), .s2_mul7(\u.s2_mul7 ), .s2_rom9(\u.s2_rom9 ),
                .s3_cmp11(\u.s3_cmp11 ), .s3_mul10(\u.s3_mul10 ), .s4_w(\u.colors.w ),
                .out_valid(out_valid[i]),
                .out({out_w[i*W_BITS +: W_BITS], out_r[i*8 +: 8], out_g[i*8 +: 8],
                      out_b[i*8 +: 8]}));
        end
    endgenerate
endmodule

// power_lane_proof: one lane, with the device's signals as inputs.
module power_lane_proof #(
    parameter integer TABLE_BITS = 8,
    parameter integer PIPELINED  = 1,
    parameter integer W_BITS     = 2 * TABLE_BITS - 3
) (
    input wire                  clk,
    input wire                  reset,
    input wire                  en,
    input wire                  started,
    input wire                  n_we,
    input wire [9:0]            n,
    input wire                  rgb_we,
    input wire [23:0]           rgb,
    input wire                  in_valid,
    input wire [18:0]           cos,
    input wire [17:0]           reg1,
    input wire [9:0]            reg2,
    input wire [4*24-1:0]       rgbs,
    input wire [3:0]            valids,
    input wire [TABLE_BITS-1:0] address9,
    input wire [TABLE_BITS+3:0] rom9,
    input wire [TABLE_BITS-1:0] address33,
    input wire [W_BITS-1:0]     rom33,
    input wire                  s2_over7,
    input wire [15:0]           s2_mul7,
    input wire [TABLE_BITS+3:0] s2_rom9,
    input wire                  s3_cmp11,
    input wire [TABLE_BITS+3:0] s3_mul10,
    input wire [W_BITS-1:0]     s4_w,
    input wire                  out_valid,
    input wire [W_BITS+23:0]    out
);
    localparam LATENCY = PIPELINED != 0 ? 5 : 1;
    localparam WIDTH   = 18 + 10 + 24;
    localparam L_BITS  = 4 + TABLE_BITS;

    // What applies to a slot: 1 - cos of its cosine, or where it has none of the last one, as
    // register 1 keeps that; the material as written up to its edge and at it.
    wire [LATENCY-1:0]       valid;
    wire [LATENCY*WIDTH-1:0] history;
    wire [17:0]              its_x;
    wire [9:0]               its_n;
    wire [23:0]              its_rgb;
    wire [17:0]              x;
    assign {its_x, its_n, its_rgb} = history[WIDTH-1:0];
    power_formula_x u_x (.cos(cos), .x(x));
    wire [WIDTH-1:0] in_data = {in_valid ? x : its_x, n_we ? n : its_n, rgb_we ? rgb : its_rgb};

    // Combinational, the outputs are wires of registers 1 to 5: those are what must not change.
    wire [51:0] held = PIPELINED != 0 ? {{(28 - W_BITS){1'b0}}, out} : {reg1, reg2, rgbs[23:0]};
    flow #(.LATENCY(LATENCY), .WIDTH(WIDTH), .OUT(52)) u_flow (
        .clk(clk), .reset(reset), .en(en), .started(started),
        .in_valid(in_valid), .in_data(in_data),
        .out_valid(out_valid), .out(held), .valid(valid), .history(history));

    // The formula, each step at the place of the slot where the device has it: step 1 from
    // registers 1 and 2, which value_x and h_reg2 say hold the slot's data.
    wire [15:0]       p_1;
    wire              over_1;
    power_formula_p u_p (.x(reg1), .n(reg2), .p(p_1), .over(over_1));

    reg  [15:0]       p_2;
    reg               over_2;
    reg  [L_BITS-1:0] g_2;
    wire [L_BITS-1:0] v_2;
    wire              small_2;
    power_formula_v #(.TABLE_BITS(TABLE_BITS)) u_v (
        .p(p_2), .over(over_2), .g(g_2), .v(v_2), .small(small_2));

    reg  [L_BITS-1:0] v_3;
    reg               small_3;
    wire [W_BITS-1:0] w_3;
    power_formula_w #(.TABLE_BITS(TABLE_BITS)) u_w (
        .v(v_3), .small(small_3), .power(rom33), .w(w_3));

    wire [23:0]       its_rgb_4 = PIPELINED != 0 ? history[3*WIDTH +: 24] : rgbs[3*24 +: 24];
    reg  [W_BITS-1:0] w_4, w_5;
    wire [7:0]        r_4, g_4, b_4;
    power_formula_color #(.W_BITS(W_BITS)) u_r (.w(w_4), .color(its_rgb_4[23:16]), .product(r_4));
    power_formula_color #(.W_BITS(W_BITS)) u_g (.w(w_4), .color(its_rgb_4[15:8]), .product(g_4));
    power_formula_color #(.W_BITS(W_BITS)) u_b (.w(w_4), .color(its_rgb_4[7:0]), .product(b_4));
    reg  [7:0]        r_5, g_5, b_5;

    generate
        if (PIPELINED != 0) begin : g_steps
            always @(posedge clk)
                if (reset) begin
                    {p_2, over_2, g_2} <= {(17 + L_BITS){1'b0}};
                    {v_3, small_3}     <= {(L_BITS + 1){1'b0}};
                    w_4                <= {W_BITS{1'b0}};
                    w_5                <= {W_BITS{1'b0}};
                    {r_5, g_5, b_5}    <= 24'd0;
                end else if (en) begin
                    {p_2, over_2, g_2} <= {p_1, over_1, rom9};
                    {v_3, small_3}     <= {v_2, small_2};
                    w_4                <= w_3;
                    w_5                <= w_4;
                    {r_5, g_5, b_5}    <= {r_4, g_4, b_4};
                end

            // Helpers: the device's pipeline holds the slots' steps.
            always @* if (started) begin
                h_valid: assert (valids == valid[3:0]);
                h_rgb_2: assert (rgbs[24 +: 24] == history[WIDTH +: 24]);
                h_rgb_3: assert (rgbs[2*24 +: 24] == history[2*WIDTH +: 24]);
                h_rgb_4: assert (rgbs[3*24 +: 24] == history[3*WIDTH +: 24]);
                h_p:     assert (s2_mul7 == p_2);
                h_over:  assert (s2_over7 == over_2);
                h_g:     assert (s2_rom9 == g_2);
                h_v:     assert (s3_mul10 == v_3);
                h_small: assert (s3_cmp11 == small_3);
                h_w:     assert (s4_w == w_4);
            end
        end else begin : g_steps
            // Step by step as well: each from the device's own result of the step before, which
            // the values here say is the formula's.
            always @* {p_2, over_2, g_2} = {s2_mul7, s2_over7, s2_rom9};
            always @* {v_3, small_3} = {s3_mul10, s3_cmp11};
            always @* w_4 = s4_w;
            always @* w_5 = s4_w;
            always @* {r_5, g_5, b_5} = {r_4, g_4, b_4};
            always @* if (started) begin
                value_p:     assert (s2_mul7 == p_1);
                value_over:  assert (s2_over7 == over_1);
                value_g9:    assert (s2_rom9 == rom9);
                value_v:     assert (s3_mul10 == v_2);
                value_small: assert (s3_cmp11 == small_2);
                value_w4:    assert (s4_w == w_3);
                value_rgb_4: assert (rgbs[3*24 +: 24] == its_rgb);
            end
        end
    endgenerate

    always @* if (started) begin
        h_reg2:          assert (reg2 == its_n);
        value_x:         assert (reg1 == its_x);
        value_address9:  assert (address9 == its_x[17 -: TABLE_BITS]);
        value_address33: assert (address33 == v_3[TABLE_BITS-1:0]);
        value_rgb_1:     assert (rgbs[23:0] == its_rgb);
        value_w:         assert (out[W_BITS+23:24] == w_5);
        value_r:         assert (out[23:16] == r_5);
        value_g:         assert (out[15:8] == g_5);
        value_b:         assert (out[7:0] == b_5);
    end

    // The centre, the flank, what is beyond the last shift, a cosine out of range, at an output;
    // and a point whose material was replaced while it was on its way.
    localparam LAST = (LATENCY - 1) * WIDTH;
    reg above_1; // since the reset a code above 1.0 was taken
    always @(posedge clk)
        if (reset) above_1 <= 1'b0;
        else       above_1 <= above_1 || (en && in_valid && cos > 19'd300000);
    wire [W_BITS-1:0] out_w  = out[W_BITS+23:24];
    wire [17:0]       last_x = history[LAST+34 +: 18];
    wire [9:0]        last_n = history[LAST+24 +: 10];
    wire              shown  = started && out_valid && out[23:16] != 8'd0;
    always @* begin
        c_value_flank:    cover (shown && out_w < {2'b01, {(W_BITS - 2){1'b0}}} && last_n == 10'd9
                                 && last_x > 18'd1000);
        c_value_beyond:   cover (started && out_valid && out_w == {W_BITS{1'b0}}
                                 && last_n == 10'd1023 && history[LAST+16 +: 8] != 8'd0);
        c_value_centre:   cover (shown && last_x == 18'd0 && last_n == 10'd80);
        c_value_dark:     cover (started && out_valid && last_x == 18'h3FFFF);
        c_value_above_1:  cover (shown && above_1);
        c_value_material: cover (shown && (PIPELINED == 0
                                 || history[33:0] != history[LAST +: 34]));
    end
endmodule

`default_nettype wire
