// What ties the contents of ROM 9 to those of ROM 33: a cosine is at least the limit where,
// and only where, t is not negative. Shown by roms_proof for the real ROMs, every n and every code;
// assumed where the ROMs are free (free_roms.v).
`default_nettype none

module rom_lemma (
    input  wire [18:0] cos,
    input  wire [21:0] sigma,
    input  wire [18:0] limit,
    output wire        holds
);
    wire [27:0] t;
    formula_t u_t (.cos(cos), .sigma(sigma), .t(t));
    assign holds = (cos >= limit) == !t[27];
endmodule

`default_nettype wire
