// log2_slope_rom: how far the lines of log2 rise over their interval, m's first 7
// fraction bits -> U0.20; combinational.
//
// Made by glint-gen from cmodel/; `make generate` makes it anew.
`default_nettype none

module log2_slope_rom (
    input  wire [6:0] m,
    output reg  [13:0] slope
);
    always @*
        case (m)
            7'd0   : slope = 14'd11773;
            7'd1   : slope = 14'd11682;
            7'd2   : slope = 14'd11592;
            7'd3   : slope = 14'd11504;
            7'd4   : slope = 14'd11417;
            7'd5   : slope = 14'd11332;
            7'd6   : slope = 14'd11247;
            7'd7   : slope = 14'd11164;
            7'd8   : slope = 14'd11083;
            7'd9   : slope = 14'd11002;
            7'd10  : slope = 14'd10923;
            7'd11  : slope = 14'd10844;
            7'd12  : slope = 14'd10767;
            7'd13  : slope = 14'd10691;
            7'd14  : slope = 14'd10616;
            7'd15  : slope = 14'd10542;
            7'd16  : slope = 14'd10469;
            7'd17  : slope = 14'd10397;
            7'd18  : slope = 14'd10326;
            7'd19  : slope = 14'd10256;
            7'd20  : slope = 14'd10187;
            7'd21  : slope = 14'd10119;
            7'd22  : slope = 14'd10052;
            7'd23  : slope = 14'd9985;
            7'd24  : slope = 14'd9920;
            7'd25  : slope = 14'd9855;
            7'd26  : slope = 14'd9791;
            7'd27  : slope = 14'd9728;
            7'd28  : slope = 14'd9666;
            7'd29  : slope = 14'd9605;
            7'd30  : slope = 14'd9544;
            7'd31  : slope = 14'd9485;
            7'd32  : slope = 14'd9425;
            7'd33  : slope = 14'd9367;
            7'd34  : slope = 14'd9309;
            7'd35  : slope = 14'd9252;
            7'd36  : slope = 14'd9196;
            7'd37  : slope = 14'd9141;
            7'd38  : slope = 14'd9086;
            7'd39  : slope = 14'd9032;
            7'd40  : slope = 14'd8978;
            7'd41  : slope = 14'd8925;
            7'd42  : slope = 14'd8873;
            7'd43  : slope = 14'd8821;
            7'd44  : slope = 14'd8770;
            7'd45  : slope = 14'd8719;
            7'd46  : slope = 14'd8669;
            7'd47  : slope = 14'd8620;
            7'd48  : slope = 14'd8571;
            7'd49  : slope = 14'd8523;
            7'd50  : slope = 14'd8475;
            7'd51  : slope = 14'd8428;
            7'd52  : slope = 14'd8381;
            7'd53  : slope = 14'd8335;
            7'd54  : slope = 14'd8289;
            7'd55  : slope = 14'd8244;
            7'd56  : slope = 14'd8199;
            7'd57  : slope = 14'd8155;
            7'd58  : slope = 14'd8111;
            7'd59  : slope = 14'd8068;
            7'd60  : slope = 14'd8025;
            7'd61  : slope = 14'd7983;
            7'd62  : slope = 14'd7941;
            7'd63  : slope = 14'd7900;
            7'd64  : slope = 14'd7859;
            7'd65  : slope = 14'd7818;
            7'd66  : slope = 14'd7778;
            7'd67  : slope = 14'd7738;
            7'd68  : slope = 14'd7699;
            7'd69  : slope = 14'd7660;
            7'd70  : slope = 14'd7621;
            7'd71  : slope = 14'd7583;
            7'd72  : slope = 14'd7545;
            7'd73  : slope = 14'd7508;
            7'd74  : slope = 14'd7471;
            7'd75  : slope = 14'd7434;
            7'd76  : slope = 14'd7397;
            7'd77  : slope = 14'd7361;
            7'd78  : slope = 14'd7326;
            7'd79  : slope = 14'd7290;
            7'd80  : slope = 14'd7256;
            7'd81  : slope = 14'd7221;
            7'd82  : slope = 14'd7187;
            7'd83  : slope = 14'd7153;
            7'd84  : slope = 14'd7119;
            7'd85  : slope = 14'd7086;
            7'd86  : slope = 14'd7053;
            7'd87  : slope = 14'd7020;
            7'd88  : slope = 14'd6987;
            7'd89  : slope = 14'd6955;
            7'd90  : slope = 14'd6923;
            7'd91  : slope = 14'd6892;
            7'd92  : slope = 14'd6861;
            7'd93  : slope = 14'd6830;
            7'd94  : slope = 14'd6799;
            7'd95  : slope = 14'd6769;
            7'd96  : slope = 14'd6738;
            7'd97  : slope = 14'd6709;
            7'd98  : slope = 14'd6679;
            7'd99  : slope = 14'd6650;
            7'd100 : slope = 14'd6620;
            7'd101 : slope = 14'd6592;
            7'd102 : slope = 14'd6563;
            7'd103 : slope = 14'd6535;
            7'd104 : slope = 14'd6507;
            7'd105 : slope = 14'd6479;
            7'd106 : slope = 14'd6451;
            7'd107 : slope = 14'd6424;
            7'd108 : slope = 14'd6397;
            7'd109 : slope = 14'd6370;
            7'd110 : slope = 14'd6343;
            7'd111 : slope = 14'd6316;
            7'd112 : slope = 14'd6290;
            7'd113 : slope = 14'd6264;
            7'd114 : slope = 14'd6238;
            7'd115 : slope = 14'd6213;
            7'd116 : slope = 14'd6187;
            7'd117 : slope = 14'd6162;
            7'd118 : slope = 14'd6137;
            7'd119 : slope = 14'd6112;
            7'd120 : slope = 14'd6088;
            7'd121 : slope = 14'd6063;
            7'd122 : slope = 14'd6039;
            7'd123 : slope = 14'd6015;
            7'd124 : slope = 14'd5991;
            7'd125 : slope = 14'd5968;
            7'd126 : slope = 14'd5944;
            7'd127 : slope = 14'd5921;
        endcase
endmodule

`default_nettype wire
