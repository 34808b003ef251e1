// roms_proof: what the device's ROMs hold, for every n and every cosine code. There is no clock: a
// single state with n and cos free is all there is.
//
// Properties
//   sigma  ROM 33 holds (n+1)/3 rounded to 13 fraction bits: 3 sigma is within one unit of n + 1
//   range  and never more than 1024/3: so t is -340.34 or more, and its square fits into U17.18
//   limit  rom_lemma
`default_nettype none

module roms_proof (
    input wire [9:0]  n,
    input wire [18:0] cos
);
    wire [21:0] rom33;
    wire [18:0] rom9;
    sigma_rom u_rom33 (.n(n), .sigma(rom33));
    limit_rom u_rom9 (.n(n), .limit(rom9));

    wire [24:0] thrice = 25'd3 * rom33;
    wire [24:0] exact  = (25'd1 + n) << 13;
    wire        holds;
    rom_lemma u_lemma (.cos(cos), .sigma(rom33), .limit(rom9), .holds(holds));

    always @* begin
        sigma: assert (thrice <= exact + 25'd1 && exact <= thrice + 25'd1);
        range: assert (rom33 <= 22'd2796203);
        limit: assert (holds);

        c_sigma:        cover (thrice != exact && n == 10'd1023);
        c_range:        cover (rom33 == 22'd2796203);
        c_limit_inside: cover (cos == rom9 && n == 10'd1000);
        c_limit_behind: cover (cos + 19'd1 == rom9 && n == 10'd1000);
    end
endmodule

`default_nettype wire
