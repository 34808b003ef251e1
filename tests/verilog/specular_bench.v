// specular_bench: specular_device on vectors that the C model made, in any Verilog-2005 simulator.
//
//   +stimulus=FILE +expected=FILE   hexadecimal, a word for each of CLOCKS clocks: the pins before
//                                   its rising edge, the outputs after it
//
// Prints the first mismatches, and last "M mismatches of N". An unknown value is a mismatch.
`default_nettype none
`include "glint_formats.vh"

module specular_bench;
    parameter GATE      = 0;
    parameter PIPELINED = 1;
    parameter LANES     = 1;
    parameter CLOCKS    = 1;

    localparam IN_BITS  = 4 + `GLINT_N_BITS + 3 * `GLINT_COLOR_BITS + LANES * (1 + `GLINT_COS_BITS);
    localparam OUT_BITS = LANES * (1 + `GLINT_W_BITS + 3 * `GLINT_COLOR_BITS);

    reg [IN_BITS-1:0]  stimulus [0:CLOCKS-1];
    reg [OUT_BITS-1:0] expected [0:CLOCKS-1];
    reg [8*1024-1:0]   path;

    reg                               clk, reset, en, n_we, rgb_we;
    reg  [`GLINT_N_BITS-1:0]          n;
    reg  [`GLINT_COLOR_BITS-1:0]      r, g, b;
    reg  [LANES-1:0]                  in_valid;
    reg  [LANES*`GLINT_COS_BITS-1:0]  cos;
    wire [LANES-1:0]                  out_valid;
    wire [LANES*`GLINT_W_BITS-1:0]    out_w;
    wire [LANES*`GLINT_COLOR_BITS-1:0] out_r, out_g, out_b;

    specular_device #(.GATE(GATE), .PIPELINED(PIPELINED), .LANES(LANES)) device (
        .clk(clk), .reset(reset), .en(en), .n_we(n_we), .n(n), .rgb_we(rgb_we), .r(r), .g(g), .b(b),
        .in_valid(in_valid), .cos(cos),
        .out_valid(out_valid), .out_w(out_w), .out_r(out_r), .out_g(out_g), .out_b(out_b));

    wire [OUT_BITS-1:0] found = {out_valid, out_w, out_r, out_g, out_b};
    integer clock, mismatches, comparisons;

    initial begin
        clk = 1'b0;
        mismatches = 0;
        comparisons = 0;
        if ($value$plusargs("stimulus=%s", path)) $readmemh(path, stimulus);
        if ($value$plusargs("expected=%s", path)) $readmemh(path, expected);
        for (clock = 0; clock < CLOCKS; clock = clock + 1) begin
            {reset, en, n_we, n, rgb_we, r, g, b, in_valid, cos} = stimulus[clock];
            #5 clk = 1'b1;
            #4 comparisons = comparisons + 1;
            if (found !== expected[clock]) begin
                mismatches = mismatches + 1;
                if (mismatches <= 8)
                    $display("clock %0d: pins %h, outputs %h, expected %h", clock + 1,
                             stimulus[clock], found, expected[clock]);
            end
            #1 clk = 1'b0;
        end
        $display("%0d mismatches of %0d", mismatches, comparisons);
        $finish;
    end
endmodule

`default_nettype wire
