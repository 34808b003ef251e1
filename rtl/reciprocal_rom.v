// reciprocal_rom: the table of figure 2.13, k -> the bits i0 i1 ... in of 1/k (i0 highest),
// 2^n/k rounded to nearest, n = SHIFTS (6..16); miss: k is 0 or beyond the table;
// combinational.
//
// Example     SHIFTS = 12, k = 7: bits = 585, as 4096/7 = 585.14; miss = 0
//
// Made by glint-gen from cmodel/; `make generate` makes it anew.
`default_nettype none
`include "glint_formats.vh"

module reciprocal_rom #(
    parameter integer SHIFTS = `GLINT_DIVIDER_SHIFTS_DEFAULT
) (
    input  wire [`GLINT_DIVIDER_K_BITS-1:0] k,
    output reg  [SHIFTS:0]                  bits,
    output wire                             miss
);
    assign miss = (k == 8'd0) || (k > `GLINT_DIVIDER_K_MAX);

    generate
        if (SHIFTS == 6) begin : g_table
            always @*
                case (k)
                    8'd1 : bits = 7'd64;
                    8'd2 : bits = 7'd32;
                    8'd3 : bits = 7'd21;
                    8'd4 : bits = 7'd16;
                    8'd5 : bits = 7'd13;
                    8'd6 : bits = 7'd11;
                    8'd7 : bits = 7'd9;
                    8'd8 : bits = 7'd8;
                    8'd9 : bits = 7'd7;
                    8'd10: bits = 7'd6;
                    8'd11: bits = 7'd6;
                    8'd12: bits = 7'd5;
                    8'd13: bits = 7'd5;
                    8'd14: bits = 7'd5;
                    8'd15: bits = 7'd4;
                    8'd16: bits = 7'd4;
                    default: bits = 7'd0;
                endcase
        end else if (SHIFTS == 7) begin : g_table
            always @*
                case (k)
                    8'd1 : bits = 8'd128;
                    8'd2 : bits = 8'd64;
                    8'd3 : bits = 8'd43;
                    8'd4 : bits = 8'd32;
                    8'd5 : bits = 8'd26;
                    8'd6 : bits = 8'd21;
                    8'd7 : bits = 8'd18;
                    8'd8 : bits = 8'd16;
                    8'd9 : bits = 8'd14;
                    8'd10: bits = 8'd13;
                    8'd11: bits = 8'd12;
                    8'd12: bits = 8'd11;
                    8'd13: bits = 8'd10;
                    8'd14: bits = 8'd9;
                    8'd15: bits = 8'd9;
                    8'd16: bits = 8'd8;
                    default: bits = 8'd0;
                endcase
        end else if (SHIFTS == 8) begin : g_table
            always @*
                case (k)
                    8'd1 : bits = 9'd256;
                    8'd2 : bits = 9'd128;
                    8'd3 : bits = 9'd85;
                    8'd4 : bits = 9'd64;
                    8'd5 : bits = 9'd51;
                    8'd6 : bits = 9'd43;
                    8'd7 : bits = 9'd37;
                    8'd8 : bits = 9'd32;
                    8'd9 : bits = 9'd28;
                    8'd10: bits = 9'd26;
                    8'd11: bits = 9'd23;
                    8'd12: bits = 9'd21;
                    8'd13: bits = 9'd20;
                    8'd14: bits = 9'd18;
                    8'd15: bits = 9'd17;
                    8'd16: bits = 9'd16;
                    default: bits = 9'd0;
                endcase
        end else if (SHIFTS == 9) begin : g_table
            always @*
                case (k)
                    8'd1 : bits = 10'd512;
                    8'd2 : bits = 10'd256;
                    8'd3 : bits = 10'd171;
                    8'd4 : bits = 10'd128;
                    8'd5 : bits = 10'd102;
                    8'd6 : bits = 10'd85;
                    8'd7 : bits = 10'd73;
                    8'd8 : bits = 10'd64;
                    8'd9 : bits = 10'd57;
                    8'd10: bits = 10'd51;
                    8'd11: bits = 10'd47;
                    8'd12: bits = 10'd43;
                    8'd13: bits = 10'd39;
                    8'd14: bits = 10'd37;
                    8'd15: bits = 10'd34;
                    8'd16: bits = 10'd32;
                    default: bits = 10'd0;
                endcase
        end else if (SHIFTS == 10) begin : g_table
            always @*
                case (k)
                    8'd1 : bits = 11'd1024;
                    8'd2 : bits = 11'd512;
                    8'd3 : bits = 11'd341;
                    8'd4 : bits = 11'd256;
                    8'd5 : bits = 11'd205;
                    8'd6 : bits = 11'd171;
                    8'd7 : bits = 11'd146;
                    8'd8 : bits = 11'd128;
                    8'd9 : bits = 11'd114;
                    8'd10: bits = 11'd102;
                    8'd11: bits = 11'd93;
                    8'd12: bits = 11'd85;
                    8'd13: bits = 11'd79;
                    8'd14: bits = 11'd73;
                    8'd15: bits = 11'd68;
                    8'd16: bits = 11'd64;
                    default: bits = 11'd0;
                endcase
        end else if (SHIFTS == 11) begin : g_table
            always @*
                case (k)
                    8'd1 : bits = 12'd2048;
                    8'd2 : bits = 12'd1024;
                    8'd3 : bits = 12'd683;
                    8'd4 : bits = 12'd512;
                    8'd5 : bits = 12'd410;
                    8'd6 : bits = 12'd341;
                    8'd7 : bits = 12'd293;
                    8'd8 : bits = 12'd256;
                    8'd9 : bits = 12'd228;
                    8'd10: bits = 12'd205;
                    8'd11: bits = 12'd186;
                    8'd12: bits = 12'd171;
                    8'd13: bits = 12'd158;
                    8'd14: bits = 12'd146;
                    8'd15: bits = 12'd137;
                    8'd16: bits = 12'd128;
                    default: bits = 12'd0;
                endcase
        end else if (SHIFTS == 12) begin : g_table
            always @*
                case (k)
                    8'd1 : bits = 13'd4096;
                    8'd2 : bits = 13'd2048;
                    8'd3 : bits = 13'd1365;
                    8'd4 : bits = 13'd1024;
                    8'd5 : bits = 13'd819;
                    8'd6 : bits = 13'd683;
                    8'd7 : bits = 13'd585;
                    8'd8 : bits = 13'd512;
                    8'd9 : bits = 13'd455;
                    8'd10: bits = 13'd410;
                    8'd11: bits = 13'd372;
                    8'd12: bits = 13'd341;
                    8'd13: bits = 13'd315;
                    8'd14: bits = 13'd293;
                    8'd15: bits = 13'd273;
                    8'd16: bits = 13'd256;
                    default: bits = 13'd0;
                endcase
        end else if (SHIFTS == 13) begin : g_table
            always @*
                case (k)
                    8'd1 : bits = 14'd8192;
                    8'd2 : bits = 14'd4096;
                    8'd3 : bits = 14'd2731;
                    8'd4 : bits = 14'd2048;
                    8'd5 : bits = 14'd1638;
                    8'd6 : bits = 14'd1365;
                    8'd7 : bits = 14'd1170;
                    8'd8 : bits = 14'd1024;
                    8'd9 : bits = 14'd910;
                    8'd10: bits = 14'd819;
                    8'd11: bits = 14'd745;
                    8'd12: bits = 14'd683;
                    8'd13: bits = 14'd630;
                    8'd14: bits = 14'd585;
                    8'd15: bits = 14'd546;
                    8'd16: bits = 14'd512;
                    default: bits = 14'd0;
                endcase
        end else if (SHIFTS == 14) begin : g_table
            always @*
                case (k)
                    8'd1 : bits = 15'd16384;
                    8'd2 : bits = 15'd8192;
                    8'd3 : bits = 15'd5461;
                    8'd4 : bits = 15'd4096;
                    8'd5 : bits = 15'd3277;
                    8'd6 : bits = 15'd2731;
                    8'd7 : bits = 15'd2341;
                    8'd8 : bits = 15'd2048;
                    8'd9 : bits = 15'd1820;
                    8'd10: bits = 15'd1638;
                    8'd11: bits = 15'd1489;
                    8'd12: bits = 15'd1365;
                    8'd13: bits = 15'd1260;
                    8'd14: bits = 15'd1170;
                    8'd15: bits = 15'd1092;
                    8'd16: bits = 15'd1024;
                    default: bits = 15'd0;
                endcase
        end else if (SHIFTS == 15) begin : g_table
            always @*
                case (k)
                    8'd1 : bits = 16'd32768;
                    8'd2 : bits = 16'd16384;
                    8'd3 : bits = 16'd10923;
                    8'd4 : bits = 16'd8192;
                    8'd5 : bits = 16'd6554;
                    8'd6 : bits = 16'd5461;
                    8'd7 : bits = 16'd4681;
                    8'd8 : bits = 16'd4096;
                    8'd9 : bits = 16'd3641;
                    8'd10: bits = 16'd3277;
                    8'd11: bits = 16'd2979;
                    8'd12: bits = 16'd2731;
                    8'd13: bits = 16'd2521;
                    8'd14: bits = 16'd2341;
                    8'd15: bits = 16'd2185;
                    8'd16: bits = 16'd2048;
                    default: bits = 16'd0;
                endcase
        end else if (SHIFTS == 16) begin : g_table
            always @*
                case (k)
                    8'd1 : bits = 17'd65536;
                    8'd2 : bits = 17'd32768;
                    8'd3 : bits = 17'd21845;
                    8'd4 : bits = 17'd16384;
                    8'd5 : bits = 17'd13107;
                    8'd6 : bits = 17'd10923;
                    8'd7 : bits = 17'd9362;
                    8'd8 : bits = 17'd8192;
                    8'd9 : bits = 17'd7282;
                    8'd10: bits = 17'd6554;
                    8'd11: bits = 17'd5958;
                    8'd12: bits = 17'd5461;
                    8'd13: bits = 17'd5041;
                    8'd14: bits = 17'd4681;
                    8'd15: bits = 17'd4369;
                    8'd16: bits = 17'd4096;
                    default: bits = 17'd0;
                endcase
        end else begin : g_table
            // There is no such module: elaboration stops here.
            SHIFTS_must_be_6_to_16 error();
        end
    endgenerate
endmodule

`default_nettype wire
