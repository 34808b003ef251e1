// For Yosys's techmap: a register as a wire. Its clock enable and its reset are not looked at.
module \$_SDFFE_PP0P_ (
    input  wire C,
    input  wire D,
    input  wire E,
    input  wire R,
    output wire Q
);
    assign Q = D;
endmodule
