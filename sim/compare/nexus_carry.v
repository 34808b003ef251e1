// Nexus, after synthesis: a carry chain whose first input is 0 has it open, which means the same to
// the chip, and is what nextpnr wants.
module CCU2 (
    input CIN, A1, B1, C1, D1, A0, B0, C0, D0,
    output S1, S0, COUT
);
    parameter INJECT = "YES";
    parameter INIT0 = "0x0000";
    parameter INIT1 = "0x1111";
    parameter _TECHMAP_CONSTMSK_CIN_ = 0;
    parameter _TECHMAP_CONSTVAL_CIN_ = 0;
    wire _TECHMAP_FAIL_ = !(_TECHMAP_CONSTMSK_CIN_ === 1'b1 && _TECHMAP_CONSTVAL_CIN_ === 1'b0);
    CCU2 #(.INJECT(INJECT), .INIT0(INIT0), .INIT1(INIT1)) _TECHMAP_REPLACE_ (
        .A1(A1), .B1(B1), .C1(C1), .D1(D1), .A0(A0), .B0(B0), .C0(C0), .D0(D0),
        .S1(S1), .S0(S0), .COUT(COUT));
endmodule
