// The power device's ROMs with outputs that the prover chooses anew at every clock, whatever the
// address is: what holds with them holds with any content, so with the right one too. What of the
// real content matters is shown by power_roms_proof.
`default_nettype none

module power_log_rom #(
    parameter integer TABLE_BITS = 8
) (
    input  wire [TABLE_BITS-1:0] address,
    output wire [TABLE_BITS+3:0] g
);
    (* anyseq *) reg [TABLE_BITS+3:0] any;
    assign g = any;
    wire address_unused = &{1'b0, address};
endmodule

module power_exp_rom #(
    parameter integer TABLE_BITS = 8
) (
    input  wire [TABLE_BITS-1:0]   address,
    output wire [2*TABLE_BITS-4:0] power
);
    (* anyseq *) reg [2*TABLE_BITS-4:0] any;
    assign power = any;
    wire address_unused = &{1'b0, address};
endmodule

`default_nettype wire
