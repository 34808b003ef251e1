// device_proof: lane LANE of specular_device, any setting. The prover chooses all inputs at each
// clock, including reset and en; nothing is claimed before the first reset.
//
// Properties
//   uninvited, in_order, once, frozen   those of module flow; the data of a slot is the cosine, n
//                                       and the colour that apply to it
//   value   out_w, out_r, out_g, out_b of the slot at the output are those of the formula
//           (formula.v) for its cosine, n and colour. Each step of the formula is computed once,
//           from the slot's data, and goes on with the slot. The ROMs have the slot's n, and adder
//           8 is t, at every clock.
//
// The ROMs are free (free_roms.v), but for rom_lemma where the gate is cosine.
`default_nettype none

module device_proof #(
    parameter integer GATE      = 0,
    parameter integer PIPELINED = 1,
    parameter integer LANES     = 1,
    parameter integer LANE      = 0
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
    wire [LANES-1:0]    out_valid;
    wire [LANES*19-1:0] out_w;
    wire [LANES*8-1:0]  out_r, out_g, out_b;
    specular_device #(.GATE(GATE), .PIPELINED(PIPELINED), .LANES(LANES)) dut (
        .clk(clk), .reset(reset), .en(en), .n_we(n_we), .n(n), .rgb_we(rgb_we), .r(r), .g(g), .b(b),
        .in_valid(in_valid), .cos(cos), .out_valid(out_valid), .out_w(out_w),
        .out_r(out_r), .out_g(out_g), .out_b(out_b));

    reg started = 1'b0;
    always @(posedge clk) started <= started || reset;

    // The device's own signals: Yosys connects a wire marked hierconn to the one of that name.
    (* hierconn *) wire [9:0]       \dut.reg2 ;
    (* hierconn *) wire [7:0]       \dut.reg3 , \dut.reg4 , \dut.reg5 ;
    (* hierconn *) wire [7:0]       \dut.s2_reg3 , \dut.s2_reg4 , \dut.s2_reg5 ;
    (* hierconn *) wire [7:0]       \dut.s3_reg3 , \dut.s3_reg4 , \dut.s3_reg5 ;
    (* hierconn *) wire [21:0]      \dut.rom33 ;
    (* hierconn *) wire [9:0]       \dut.u_rom33.n ;
    (* hierconn *) wire [18:0]      \dut.rom9 , \dut.s2_rom9 ;
    (* hierconn *) wire [LANES-1:0] \dut.s1_valid , \dut.s2_valid , \dut.s3_valid ;

    // ROM 9 is there for gate cosine only.
    wire [9:0] rom9_n;
    generate
        if (GATE == 0) begin : \dut.g_rom9
            (* hierconn *) wire [9:0] \u_rom9.n ;
            assign rom9_n = \u_rom9.n ;
        end else begin : g_no_rom9
            assign rom9_n = \dut.reg2 ;
        end
    endgenerate

    genvar i;
    generate
        for (i = LANE; i <= LANE; i = i + 1) begin : \dut.lane
            (* hierconn *) wire [18:0] \u.reg1 , \u.s3_keys12 ;
            (* hierconn *) wire [27:0] \u.adder8 , \u.s2_adder8 ;
            (* hierconn *) wire        \u.s2_cmp11 ;

            lane_proof #(.GATE(GATE), .PIPELINED(PIPELINED)) u_proof (
                .clk(clk), .reset(reset), .en(en), .started(started),
                .n_we(n_we), .n(n), .rgb_we(rgb_we), .rgb({r, g, b}),
                .in_valid(in_valid[i]), .cos(cos[i*19 +: 19]),
                .reg1(\u.reg1 ), .reg2(\dut.reg2 ), .rgb_1({\dut.reg3 , \dut.reg4 , \dut.reg5 }),
                .rgb_2({\dut.s2_reg3 , \dut.s2_reg4 , \dut.s2_reg5 }),
                .rgb_3({\dut.s3_reg3 , \dut.s3_reg4 , \dut.s3_reg5 }),
                .valids({\dut.s3_valid [i], \dut.s2_valid [i], \dut.s1_valid [i]}),
                .rom33_n(\dut.u_rom33.n ), .rom9_n(rom9_n),
                .rom33(\dut.rom33 ), .rom9(\dut.rom9 ), .s2_rom9(\dut.s2_rom9 ),
                .adder8(\u.adder8 ), .s2_adder8(\u.s2_adder8 ), .s2_cmp11(\u.s2_cmp11 ),
                .s3_keys12(\u.s3_keys12 ),
                .out_valid(out_valid[i]),
                .out({out_w[i*19 +: 19], out_r[i*8 +: 8], out_g[i*8 +: 8], out_b[i*8 +: 8]}));
        end
    endgenerate
endmodule

// lane_proof: one lane, with the device's signals as inputs.
module lane_proof #(
    parameter integer GATE      = 0,
    parameter integer PIPELINED = 1
) (
    input wire        clk,
    input wire        reset,
    input wire        en,
    input wire        started,
    input wire        n_we,
    input wire [9:0]  n,
    input wire        rgb_we,
    input wire [23:0] rgb,
    input wire        in_valid,
    input wire [18:0] cos,
    input wire [18:0] reg1,
    input wire [9:0]  reg2,
    input wire [23:0] rgb_1,
    input wire [23:0] rgb_2,
    input wire [23:0] rgb_3,
    input wire [2:0]  valids,
    input wire [9:0]  rom33_n,
    input wire [9:0]  rom9_n,
    input wire [21:0] rom33,
    input wire [18:0] rom9,
    input wire [18:0] s2_rom9,
    input wire [27:0] adder8,
    input wire [27:0] s2_adder8,
    input wire        s2_cmp11,
    input wire [18:0] s3_keys12,
    input wire        out_valid,
    input wire [42:0] out
);
    localparam LATENCY = PIPELINED != 0 ? 4 : 1;
    localparam WIDTH   = 19 + 10 + 24;

    // What applies to a slot: its cosine, at most 1.0, or where it has none the last one, as
    // register 1 keeps that; the material as written up to its edge and at it.
    wire [LATENCY-1:0]       valid;
    wire [LATENCY*WIDTH-1:0] history;
    wire [18:0]              its_cos;
    wire [9:0]               its_n;
    wire [23:0]              its_rgb;
    assign {its_cos, its_n, its_rgb} = history[WIDTH-1:0];
    wire [WIDTH-1:0] in_data = {!in_valid ? its_cos : cos > 19'd262144 ? 19'd262144 : cos,
                               n_we ? n : its_n, rgb_we ? rgb : its_rgb};

    // Combinational, the outputs are wires of registers 1 to 5: those are what must not change.
    wire [52:0] held = PIPELINED != 0 ? {10'd0, out} : {reg1, reg2, rgb_1};
    flow #(.LATENCY(LATENCY), .WIDTH(WIDTH), .OUT(53)) u_flow (
        .clk(clk), .reset(reset), .en(en), .started(started),
        .in_valid(in_valid), .in_data(in_data),
        .out_valid(out_valid), .out(held), .valid(valid), .history(history));

    // The formula, each step at the place of the slot where the device has it, from registers 1 to
    // 5, which value_cos and value_rgb say hold the slot's data.
    wire [27:0] t_1;
    formula_t u_t (.cos(reg1), .sigma(rom33), .t(t_1));

    reg  [27:0] t_2;
    reg         inside_2;
    wire [18:0] w_2;
    formula_w #(.GATE(GATE)) u_w (.t(t_2), .inside(inside_2), .w(w_2));

    wire [23:0] its_rgb_3 = PIPELINED != 0 ? history[2*WIDTH +: 24] : rgb_1;
    reg  [18:0] w_3;
    wire [7:0]  r_3, g_3, b_3;
    formula_color u_r (.w(w_3), .color(its_rgb_3[23:16]), .product(r_3));
    formula_color u_g (.w(w_3), .color(its_rgb_3[15:8]), .product(g_3));
    formula_color u_b (.w(w_3), .color(its_rgb_3[7:0]), .product(b_3));
    reg  [18:0] w_4;
    reg  [7:0]  r_4, g_4, b_4;

    generate
        if (PIPELINED != 0) begin : g_steps
            always @(posedge clk)
                if (reset) begin
                    inside_2        <= 1'b0;
                    t_2             <= 28'd0;
                    w_3             <= 19'd0;
                    w_4             <= 19'd0;
                    r_4             <= 8'd0;
                    g_4             <= 8'd0;
                    b_4             <= 8'd0;
                end else if (en) begin
                    inside_2        <= !t_1[27];
                    t_2             <= t_1;
                    w_3             <= w_2;
                    w_4             <= w_3;
                    r_4             <= r_3;
                    g_4             <= g_3;
                    b_4             <= b_3;
                end

            // Helpers: the device's pipeline holds the slots' steps.
            always @* if (started) begin
                h_valid_1: assert (valids[0] == valid[0]);
                h_valid_2: assert (valids[1] == valid[1]);
                h_valid_3: assert (valids[2] == valid[2]);
                h_r_2:     assert (rgb_2[23:16] == history[WIDTH+16 +: 8]);
                h_g_2:     assert (rgb_2[15:8] == history[WIDTH+8 +: 8]);
                h_b_2:     assert (rgb_2[7:0] == history[WIDTH +: 8]);
                h_r_3:     assert (rgb_3[23:16] == history[2*WIDTH+16 +: 8]);
                h_g_3:     assert (rgb_3[15:8] == history[2*WIDTH+8 +: 8]);
                h_b_3:     assert (rgb_3[7:0] == history[2*WIDTH +: 8]);
                h_t:       assert (s2_adder8 == t_2);
                h_inside:  assert (GATE == 2 || s2_cmp11 == inside_2);
                h_rom9:    assert (GATE != 2 || s2_rom9 == 19'd514 || t_2 == 28'd0);
                h_w:       assert (s3_keys12 == w_3);
            end
        end else begin : g_steps
            // Step by step as well: each from the device's own result of the step before, which
            // value_t and value_keys say is the formula's.
            always @* {inside_2, t_2} = {!adder8[27], adder8};
            always @* w_3 = s3_keys12;
            always @* w_4 = s3_keys12;
            always @* {r_4, g_4, b_4} = {r_3, g_3, b_3};
            always @* if (started) begin
                value_keys: assert (s3_keys12 == w_2);
            end
        end
    endgenerate

    wire holds;
    rom_lemma u_lemma (.cos(reg1), .sigma(rom33), .limit(rom9), .holds(holds));

    always @* begin
        if (GATE == 0) assume (holds);
        if (started) begin
            h_reg2:      assert (reg2 == its_n);
            value_cos:   assert (reg1 == its_cos);
            value_n:     assert (rom33_n == its_n && rom9_n == its_n);
            value_rgb_r: assert (rgb_1[23:16] == its_rgb[23:16]);
            value_rgb_g: assert (rgb_1[15:8] == its_rgb[15:8]);
            value_rgb_b: assert (rgb_1[7:0] == its_rgb[7:0]);
            value_t:     assert (adder8 == t_1);
            value_w:     assert (out[42:24] == w_4);
            value_r:     assert (out[23:16] == r_4);
            value_g:     assert (out[15:8] == g_4);
            value_b:     assert (out[7:0] == b_4);
        end
    end

    // Both sides of the edge, the centre, a cosine out of range, at an output; and a point whose
    // material was replaced while it was on its way.
    localparam LAST = (LATENCY - 1) * WIDTH;
    reg above_1; // since the reset a code above 1.0 was taken
    always @(posedge clk)
        if (reset) above_1 <= 1'b0;
        else       above_1 <= above_1 || (en && in_valid && cos > 19'd300000);
    wire [18:0] out_w    = out[42:24];
    wire [18:0] last_cos = history[LAST+34 +: 19];
    wire        shown    = started && out_valid && out[23:16] != 8'd0;
    always @* begin
        c_value_inside:   cover (shown && out_w < 19'd200000 && last_cos < 19'd262000);
        c_value_outside:  cover (started && out_valid && out_w == 19'd0 && last_cos > 19'd100
                                 && history[LAST+16 +: 8] != 8'd0);
        c_value_centre:   cover (shown && out_w == 19'd262144 && last_cos == 19'd262144);
        c_value_above_1:  cover (shown && above_1);
        c_value_material: cover (shown && out_w < 19'd262144 && (PIPELINED == 0
                                 || history[33:0] != history[LAST +: 34]));
    end
endmodule

`default_nettype wire
