// A little circuit with the specular device's pins, for the test of points.ys and prove.sh: two
// ranks of registers. FLAW 0 keeps every premise of points.ys; each of the others breaks one.
`default_nettype none

module specular_device #(
    parameter integer FLAW = 0
) (
    input  wire        clk,
    input  wire        reset,
    input  wire        en,
    input  wire        n_we,
    input  wire [9:0]  n,
    input  wire        rgb_we,
    input  wire [7:0]  r,
    input  wire [7:0]  g,
    input  wire [7:0]  b,
    input  wire        in_valid,
    input  wire [18:0] cos,
    output reg         out_valid,
    output wire [18:0] out_w,
    output wire [7:0]  out_r,
    output wire [7:0]  out_g,
    output wire [7:0]  out_b
);
    reg [9:0]  first_n;
    reg [18:0] first_cos;
    reg [23:0] first_rgb;
    reg        first_valid;
    reg [18:0] w;
    reg [23:0] rgb;
    reg        live;  // 0 after the reset, and never again
    reg        never; // always 0

    localparam [18:0] ONE = 19'h40000;

    wire reads_late   = FLAW == 1;
    wire is_freed     = FLAW == 2;
    wire is_marked    = FLAW == 3;
    wire is_sum       = FLAW == 4;
    wire is_mixed     = FLAW == 5;
    wire is_muted     = FLAW == 6;
    wire is_resetless = FLAW == 7;

    always @(posedge clk)
        if (reset)           first_n <= 10'd0;
        else if (en && n_we) first_n <= n ^ (is_mixed ? cos[9:0] : 10'd0);

    always @(posedge clk)
        if (reset)               first_cos <= 19'd0;
        else if (en && in_valid) first_cos <= cos > ONE ? ONE : cos;

    always @(posedge clk)
        if (reset)             first_rgb <= 24'd0;
        else if (en && rgb_we) first_rgb <= {r, g, b};

    always @(posedge clk)
        if (reset)   {first_valid, out_valid} <= 2'd0;
        else if (en) {first_valid, out_valid} <= {in_valid, first_valid};

    always @(posedge clk)
        if (reset)   {live, never} <= 2'd0;
        else if (en) {live, never} <= {first_cos <= ONE, first_cos > ONE};

    always @(posedge clk)
        if (reset)               w <= 19'd0;
        else if (en || is_freed) w <= (first_cos & {9'd0, first_n}) + (is_sum ? w : 19'd0) +
                                      {18'd0, is_marked & first_valid};

    always @(posedge clk)
        if (reset && !is_resetless) rgb <= 24'd0;
        else if (en)                rgb <= first_rgb;

    assign out_w                 = w ^ {18'd0, never} ^ (reads_late ? first_cos : 19'd0);
    assign {out_r, out_g, out_b} = is_muted && !en ? 24'd0 : live ? rgb : ~rgb;
endmodule

`default_nettype wire
