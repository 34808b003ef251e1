// log2_base_rom: where the lines of log2 begin, m's first 7 fraction bits -> U1.22;
// combinational.
//
// Made by glint-gen from cmodel/; `make generate` makes it anew.
`default_nettype none

module log2_base_rom (
    input  wire [6:0] m,
    output reg  [22:0] base
);
    always @*
        case (m)
            7'd0   : base = 23'd23;
            7'd1   : base = 23'd47113;
            7'd2   : base = 23'd93840;
            7'd3   : base = 23'd140208;
            7'd4   : base = 23'd186224;
            7'd5   : base = 23'd231893;
            7'd6   : base = 23'd277219;
            7'd7   : base = 23'd322209;
            7'd8   : base = 23'd366866;
            7'd9   : base = 23'd411196;
            7'd10  : base = 23'd455204;
            7'd11  : base = 23'd498894;
            7'd12  : base = 23'd542271;
            7'd13  : base = 23'd585340;
            7'd14  : base = 23'd628104;
            7'd15  : base = 23'd670567;
            7'd16  : base = 23'd712735;
            7'd17  : base = 23'd754611;
            7'd18  : base = 23'd796200;
            7'd19  : base = 23'd837504;
            7'd20  : base = 23'd878528;
            7'd21  : base = 23'd919276;
            7'd22  : base = 23'd959752;
            7'd23  : base = 23'd999958;
            7'd24  : base = 23'd1039900;
            7'd25  : base = 23'd1079579;
            7'd26  : base = 23'd1119000;
            7'd27  : base = 23'd1158165;
            7'd28  : base = 23'd1197079;
            7'd29  : base = 23'd1235744;
            7'd30  : base = 23'd1274164;
            7'd31  : base = 23'd1312341;
            7'd32  : base = 23'd1350279;
            7'd33  : base = 23'd1387980;
            7'd34  : base = 23'd1425449;
            7'd35  : base = 23'd1462686;
            7'd36  : base = 23'd1499696;
            7'd37  : base = 23'd1536481;
            7'd38  : base = 23'd1573043;
            7'd39  : base = 23'd1609386;
            7'd40  : base = 23'd1645512;
            7'd41  : base = 23'd1681423;
            7'd42  : base = 23'd1717123;
            7'd43  : base = 23'd1752613;
            7'd44  : base = 23'd1787897;
            7'd45  : base = 23'd1822975;
            7'd46  : base = 23'd1857852;
            7'd47  : base = 23'd1892529;
            7'd48  : base = 23'd1927008;
            7'd49  : base = 23'd1961292;
            7'd50  : base = 23'd1995383;
            7'd51  : base = 23'd2029282;
            7'd52  : base = 23'd2062993;
            7'd53  : base = 23'd2096517;
            7'd54  : base = 23'd2129856;
            7'd55  : base = 23'd2163013;
            7'd56  : base = 23'd2195989;
            7'd57  : base = 23'd2228786;
            7'd58  : base = 23'd2261407;
            7'd59  : base = 23'd2293852;
            7'd60  : base = 23'd2326125;
            7'd61  : base = 23'd2358226;
            7'd62  : base = 23'd2390158;
            7'd63  : base = 23'd2421922;
            7'd64  : base = 23'd2453521;
            7'd65  : base = 23'd2484955;
            7'd66  : base = 23'd2516227;
            7'd67  : base = 23'd2547338;
            7'd68  : base = 23'd2578290;
            7'd69  : base = 23'd2609084;
            7'd70  : base = 23'd2639723;
            7'd71  : base = 23'd2670207;
            7'd72  : base = 23'd2700538;
            7'd73  : base = 23'd2730718;
            7'd74  : base = 23'd2760748;
            7'd75  : base = 23'd2790630;
            7'd76  : base = 23'd2820365;
            7'd77  : base = 23'd2849955;
            7'd78  : base = 23'd2879401;
            7'd79  : base = 23'd2908704;
            7'd80  : base = 23'd2937866;
            7'd81  : base = 23'd2966888;
            7'd82  : base = 23'd2995771;
            7'd83  : base = 23'd3024518;
            7'd84  : base = 23'd3053128;
            7'd85  : base = 23'd3081604;
            7'd86  : base = 23'd3109946;
            7'd87  : base = 23'd3138156;
            7'd88  : base = 23'd3166236;
            7'd89  : base = 23'd3194185;
            7'd90  : base = 23'd3222007;
            7'd91  : base = 23'd3249700;
            7'd92  : base = 23'd3277268;
            7'd93  : base = 23'd3304711;
            7'd94  : base = 23'd3332029;
            7'd95  : base = 23'd3359225;
            7'd96  : base = 23'd3386299;
            7'd97  : base = 23'd3413253;
            7'd98  : base = 23'd3440087;
            7'd99  : base = 23'd3466803;
            7'd100 : base = 23'd3493401;
            7'd101 : base = 23'd3519883;
            7'd102 : base = 23'd3546249;
            7'd103 : base = 23'd3572501;
            7'd104 : base = 23'd3598640;
            7'd105 : base = 23'd3624666;
            7'd106 : base = 23'd3650581;
            7'd107 : base = 23'd3676385;
            7'd108 : base = 23'd3702080;
            7'd109 : base = 23'd3727666;
            7'd110 : base = 23'd3753144;
            7'd111 : base = 23'd3778516;
            7'd112 : base = 23'd3803781;
            7'd113 : base = 23'd3828942;
            7'd114 : base = 23'd3853998;
            7'd115 : base = 23'd3878951;
            7'd116 : base = 23'd3903802;
            7'd117 : base = 23'd3928551;
            7'd118 : base = 23'd3953199;
            7'd119 : base = 23'd3977747;
            7'd120 : base = 23'd4002196;
            7'd121 : base = 23'd4026546;
            7'd122 : base = 23'd4050799;
            7'd123 : base = 23'd4074955;
            7'd124 : base = 23'd4099015;
            7'd125 : base = 23'd4122980;
            7'd126 : base = 23'd4146850;
            7'd127 : base = 23'd4170621;
        endcase
endmodule

`default_nettype wire
