// Nexus, for its clock rate: the unit between registers, clocked by the oscillator of the chip.
module compare_clocked (
    input  wire in,
    output wire out
);
    wire clk;
    OSCA #(.HF_OSC_EN("ENABLED"), .HF_CLK_DIV("2")) oscillator (.HFOUTEN(1'b1), .HFCLKOUT(clk));
    compare_unit timed (.clk(clk), .in(in), .out(out));
endmodule
