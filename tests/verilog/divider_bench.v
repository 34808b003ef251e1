// divider_bench: both forms of the divider on vectors that the C model made; as specular_bench.
`default_nettype none
`include "glint_formats.vh"

module divider_bench;
    parameter PIPELINED = 1;
    parameter SHIFTS    = 12;
    parameter CLOCKS    = 1;

    localparam D        = `GLINT_DIVIDER_DIFFERENCE_BITS;
    localparam W        = D + SHIFTS;
    localparam PARTS    = PIPELINED ? 3 : 1;
    localparam IN_BITS  = 3 + `GLINT_DIVIDER_K_BITS + PARTS * D;
    localparam OUT_BITS = 2 + (PIPELINED ? 0 : 1) + PARTS * W;

    reg [IN_BITS-1:0]  stimulus [0:CLOCKS-1];
    reg [OUT_BITS-1:0] expected [0:CLOCKS-1];
    reg [8*1024-1:0]   path;

    reg                             clk, reset, en, start;
    reg [`GLINT_DIVIDER_K_BITS-1:0] k;
    reg [PARTS*D-1:0]               difference; // of R highest
    wire [OUT_BITS-1:0]             found;

    generate
        if (PIPELINED != 0) begin : g_form
            wire                out_valid, out_of_table;
            wire signed [W-1:0] quotient_r, quotient_g, quotient_b;
            pipelined_divider #(.SHIFTS(SHIFTS)) divider (
                .clk(clk), .reset(reset), .en(en), .in_valid(start), .k(k),
                .difference_r(difference[2*D +: D]), .difference_g(difference[D +: D]),
                .difference_b(difference[0 +: D]),
                .out_valid(out_valid), .out_of_table(out_of_table),
                .quotient_r(quotient_r), .quotient_g(quotient_g), .quotient_b(quotient_b));
            assign found = {out_valid, out_of_table, quotient_r, quotient_g, quotient_b};
        end else begin : g_form
            wire                busy, done, out_of_table;
            wire signed [W-1:0] quotient;
            shift_divider #(.SHIFTS(SHIFTS)) divider (
                .clk(clk), .reset(reset), .en(en), .start(start), .difference(difference), .k(k),
                .busy(busy), .done(done), .quotient(quotient), .out_of_table(out_of_table));
            assign found = {busy, done, out_of_table, quotient};
        end
    endgenerate

    integer clock, mismatches, comparisons;

    initial begin
        clk = 1'b0;
        mismatches = 0;
        comparisons = 0;
        if ($value$plusargs("stimulus=%s", path)) $readmemh(path, stimulus);
        if ($value$plusargs("expected=%s", path)) $readmemh(path, expected);
        for (clock = 0; clock < CLOCKS; clock = clock + 1) begin
            {reset, en, start, k, difference} = stimulus[clock];
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
