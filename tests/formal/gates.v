// gates_proof: lane LANE of two devices with the same inputs, one of gate cosine, one of gate sign.
//
// Properties
//   gates_equal  after a reset all outputs of both are equal at every clock, valid or not: for
//                every n, cosine code (out of range, too) and colour, however they follow each
//                other.
//
// The ROMs are free (free_roms.v), and so are the multipliers' results (prove.sh cuts them off),
// but for what holds of the real ones:
//   - what ROM 33 and a multiplier give is the same in both devices where their inputs are the
//     same: they are the same module or expression without memory
//   - comparator 11 of gate cosine says what the sign of adder 8 says: rom_lemma, adder 8 being its
//     t (device_proof, value)
`default_nettype none

module gates_proof #(
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
    wire [LANES-1:0]    c_valid, s_valid;
    wire [LANES*19-1:0] c_w, s_w;
    wire [LANES*8-1:0]  c_r, c_g, c_b, s_r, s_g, s_b;
    specular_device #(.GATE(0), .PIPELINED(PIPELINED), .LANES(LANES)) cosine (
        .clk(clk), .reset(reset), .en(en), .n_we(n_we), .n(n), .rgb_we(rgb_we), .r(r), .g(g), .b(b),
        .in_valid(in_valid), .cos(cos), .out_valid(c_valid), .out_w(c_w),
        .out_r(c_r), .out_g(c_g), .out_b(c_b));
    specular_device #(.GATE(1), .PIPELINED(PIPELINED), .LANES(LANES)) sign (
        .clk(clk), .reset(reset), .en(en), .n_we(n_we), .n(n), .rgb_we(rgb_we), .r(r), .g(g), .b(b),
        .in_valid(in_valid), .cos(cos), .out_valid(s_valid), .out_w(s_w),
        .out_r(s_r), .out_g(s_g), .out_b(s_b));

    reg started = 1'b0;
    always @(posedge clk) started <= started || reset;

    (* hierconn *) wire [9:0]       \cosine.reg2 , \sign.reg2 ;
    (* hierconn *) wire [7:0]       \cosine.reg3 , \cosine.reg4 , \cosine.reg5 ;
    (* hierconn *) wire [7:0]       \sign.reg3 , \sign.reg4 , \sign.reg5 ;
    (* hierconn *) wire [7:0]       \cosine.s2_reg3 , \cosine.s2_reg4 , \cosine.s2_reg5 ;
    (* hierconn *) wire [7:0]       \sign.s2_reg3 , \sign.s2_reg4 , \sign.s2_reg5 ;
    (* hierconn *) wire [7:0]       \cosine.s3_reg3 , \cosine.s3_reg4 , \cosine.s3_reg5 ;
    (* hierconn *) wire [7:0]       \sign.s3_reg3 , \sign.s3_reg4 , \sign.s3_reg5 ;
    (* hierconn *) wire [LANES-1:0] \cosine.s1_valid , \cosine.s2_valid , \cosine.s3_valid ;
    (* hierconn *) wire [LANES-1:0] \sign.s1_valid , \sign.s2_valid , \sign.s3_valid ;
    (* hierconn *) wire [21:0]      \cosine.rom33 , \sign.rom33 ;
    (* hierconn *) wire [18:0]      \cosine.rom9 ;

    // Helpers, a register at a time: what both have is equal.
    same #(.WIDTH(10)) u_reg2 (.started(started), .a(\cosine.reg2 ), .b(\sign.reg2 ));
    same #(.WIDTH(8)) u_reg3 (.started(started), .a(\cosine.reg3 ), .b(\sign.reg3 ));
    same #(.WIDTH(8)) u_reg4 (.started(started), .a(\cosine.reg4 ), .b(\sign.reg4 ));
    same #(.WIDTH(8)) u_reg5 (.started(started), .a(\cosine.reg5 ), .b(\sign.reg5 ));
    same #(.WIDTH(8)) u_s2_reg3 (.started(started), .a(\cosine.s2_reg3 ), .b(\sign.s2_reg3 ));
    same #(.WIDTH(8)) u_s2_reg4 (.started(started), .a(\cosine.s2_reg4 ), .b(\sign.s2_reg4 ));
    same #(.WIDTH(8)) u_s2_reg5 (.started(started), .a(\cosine.s2_reg5 ), .b(\sign.s2_reg5 ));
    same #(.WIDTH(8)) u_s3_reg3 (.started(started), .a(\cosine.s3_reg3 ), .b(\sign.s3_reg3 ));
    same #(.WIDTH(8)) u_s3_reg4 (.started(started), .a(\cosine.s3_reg4 ), .b(\sign.s3_reg4 ));
    same #(.WIDTH(8)) u_s3_reg5 (.started(started), .a(\cosine.s3_reg5 ), .b(\sign.s3_reg5 ));
    same #(.WIDTH(LANES)) u_1_valid (.started(started), .a(\cosine.s1_valid ), .b(\sign.s1_valid ));
    same #(.WIDTH(LANES)) u_2_valid (.started(started), .a(\cosine.s2_valid ), .b(\sign.s2_valid ));
    same #(.WIDTH(LANES)) u_3_valid (.started(started), .a(\cosine.s3_valid ), .b(\sign.s3_valid ));

    wire [18:0] c_reg1, c_s3_keys12, s_reg1, s_s3_keys12;
    wire [27:0] c_adder8, c_s2_adder8, s_s2_adder8;
    wire        c_s2_cmp11, s_s2_cmp11;
    wire [40:0] c_sum7, s_sum7;
    wire [37:0] c_sum10, s_sum10;
    wire [23:0] c_mul, s_mul; // 13, 14, 15
    same #(.WIDTH(19)) u_reg1 (.started(started), .a(c_reg1), .b(s_reg1));
    same #(.WIDTH(28)) u_adder8 (.started(started), .a(c_s2_adder8), .b(s_s2_adder8));
    same #(.WIDTH(1)) u_cmp11 (.started(started), .a(c_s2_cmp11), .b(s_s2_cmp11));
    same #(.WIDTH(19)) u_keys12 (.started(started), .a(c_s3_keys12), .b(s_s3_keys12));

    genvar i;
    generate
        for (i = LANE; i <= LANE; i = i + 1) begin : \cosine.lane
            (* hierconn *) wire [18:0] \u.reg1 , \u.s3_keys12 ;
            (* hierconn *) wire [27:0] \u.adder8 , \u.s2_adder8 ;
            (* hierconn *) wire        \u.s2_cmp11 ;
            (* hierconn *) wire [40:0] \u.sum7 ;
            (* hierconn *) wire [37:0] \u.g_square.sum10 ;
            (* hierconn *) wire [7:0]  \u.mul13 , \u.mul14 , \u.mul15 ;
            assign {c_reg1, c_adder8, c_s2_adder8, c_s2_cmp11, c_s3_keys12} =
                {\u.reg1 , \u.adder8 , \u.s2_adder8 , \u.s2_cmp11 , \u.s3_keys12 };
            assign {c_sum7, c_sum10, c_mul} =
                {\u.sum7 , \u.g_square.sum10 , \u.mul13 , \u.mul14 , \u.mul15 };
        end
        for (i = LANE; i <= LANE; i = i + 1) begin : \sign.lane
            (* hierconn *) wire [18:0] \u.reg1 , \u.s3_keys12 ;
            (* hierconn *) wire [27:0] \u.s2_adder8 ;
            (* hierconn *) wire        \u.s2_cmp11 ;
            (* hierconn *) wire [40:0] \u.sum7 ;
            (* hierconn *) wire [37:0] \u.g_square.sum10 ;
            (* hierconn *) wire [7:0]  \u.mul13 , \u.mul14 , \u.mul15 ;
            assign {s_reg1, s_s2_adder8, s_s2_cmp11, s_s3_keys12} =
                {\u.reg1 , \u.s2_adder8 , \u.s2_cmp11 , \u.s3_keys12 };
            assign {s_sum7, s_sum10, s_mul} =
                {\u.sum7 , \u.g_square.sum10 , \u.mul13 , \u.mul14 , \u.mul15 };
        end
    endgenerate

    // Outside the highlight, by a hair, just before.
    reg was_on_the_rim;
    always @(posedge clk) was_on_the_rim <= &c_adder8 && en && !reset;

    always @* begin
        assume (\cosine.reg2 != \sign.reg2 || \cosine.rom33 == \sign.rom33 );
        assume (c_reg1 != s_reg1 || \cosine.rom33 != \sign.rom33 || c_sum7 == s_sum7);
        assume (c_s2_adder8 != s_s2_adder8 || c_sum10 == s_sum10);
        assume (c_s3_keys12 != s_s3_keys12 || \cosine.s3_reg3 != \sign.s3_reg3
                || c_mul[23:16] == s_mul[23:16]);
        assume (c_s3_keys12 != s_s3_keys12 || \cosine.s3_reg4 != \sign.s3_reg4
                || c_mul[15:8] == s_mul[15:8]);
        assume (c_s3_keys12 != s_s3_keys12 || \cosine.s3_reg5 != \sign.s3_reg5
                || c_mul[7:0] == s_mul[7:0]);
        assume ((c_reg1 >= \cosine.rom9 ) == !c_adder8[27]);
        if (started) begin
            gates_equal_valid: assert (c_valid[LANE] == s_valid[LANE]);
            gates_equal_w:     assert (c_w[LANE*19 +: 19] == s_w[LANE*19 +: 19]);
            gates_equal_r:     assert (c_r[LANE*8 +: 8] == s_r[LANE*8 +: 8]);
            gates_equal_g:     assert (c_g[LANE*8 +: 8] == s_g[LANE*8 +: 8]);
            gates_equal_b:     assert (c_b[LANE*8 +: 8] == s_b[LANE*8 +: 8]);
        end

        c_gates_equal_inside: cover (started && c_valid[LANE] && c_w[LANE*19 +: 19] < 19'd99999
                                     && c_r[LANE*8 +: 8] != 8'd0);
        c_gates_equal_rim:    cover (started && was_on_the_rim && !reset);
    end
endmodule

// same: after a reset both are equal.
module same #(
    parameter integer WIDTH = 1
) (
    input wire             started,
    input wire [WIDTH-1:0] a,
    input wire [WIDTH-1:0] b
);
    always @* if (started) h_same: assert (a == b);
endmodule

`default_nettype wire
