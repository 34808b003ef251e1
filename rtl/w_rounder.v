// w_rounder: W with its last places rounded off.
//
// Function    rounded = w / 2^W_DROP, so that it stands for the same number in fewer places
// Formats     w U1.W_FRAC_BITS, at most 1.0;  rounded U1.(W_FRAC_BITS - W_DROP)
// Rounding    half up; 1.0 stays 1.0, and what did not fall does not fall
// Latency     combinational; no reset, no handshake
// Parameters  W_FRAC_BITS  fraction bits of w
//             W_DROP       0 (default): rounded is w; less than W_FRAC_BITS
`default_nettype none
`include "glint_formats.vh"

module w_rounder #(
    parameter integer W_FRAC_BITS = `GLINT_W_FRAC_BITS,
    parameter integer W_DROP      = 0
) (
    input  wire [W_FRAC_BITS:0]        w,
    output wire [W_FRAC_BITS-W_DROP:0] rounded
);
    generate
        if (W_DROP == 0) begin : g_round
            assign rounded = w;
        end else begin : g_round
            assign rounded = w[W_FRAC_BITS:W_DROP] + {{(W_FRAC_BITS - W_DROP){1'b0}}, w[W_DROP-1]};
            if (W_DROP > 1) begin : g_rest
                wire low_unused = &{1'b0, w[W_DROP-2:0]};
            end
        end
    endgenerate
endmodule

`default_nettype wire
