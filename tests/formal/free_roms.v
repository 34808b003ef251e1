// The device's ROMs with outputs that the prover chooses anew at every clock, whatever n is: what
// holds with them holds with any content, so with the right one too. What the real ROMs hold is
// shown by roms_proof.
`default_nettype none

module sigma_rom (
    input  wire [9:0]  n,
    output wire [21:0] sigma
);
    (* anyseq *) reg [21:0] any;
    assign sigma = any;
    wire n_unused = &{1'b0, n};
endmodule

module limit_rom (
    input  wire [9:0]  n,
    output wire [18:0] limit
);
    (* anyseq *) reg [18:0] any;
    assign limit = any;
    wire n_unused = &{1'b0, n};
endmodule

`default_nettype wire
