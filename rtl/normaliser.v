// normaliser: how many zeros stand before the first 1 of a value, and the value shifted by as many;
// combinational.
//
// Function    lead = zeros before the first 1, WIDTH - 1 where there is none; shifted = value <<
//             lead
// Parameters  WIDTH, LEAD_BITS: bits of value and of lead, 2^LEAD_BITS >= WIDTH
`default_nettype none

module normaliser #(
    parameter integer WIDTH     = 18,
    parameter integer LEAD_BITS = 5
) (
    input  wire [WIDTH-1:0]     value,
    output reg  [LEAD_BITS-1:0] lead,
    output wire [WIDTH-1:0]     shifted
);
    integer i;
    always @* begin
        lead = WIDTH[LEAD_BITS-1:0] - 1'b1;
        for (i = 0; i < WIDTH; i = i + 1)
            if (value[i]) lead = WIDTH[LEAD_BITS-1:0] - 1'b1 - i[LEAD_BITS-1:0];
    end

    assign shifted = value << lead;
endmodule

`default_nettype wire
