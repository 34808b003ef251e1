// newton_rom: the seed of 1/m for the unit of Schlick's by Newton's step, m's first 7
// fraction bits -> 1/m in the middle, U0.10, rounded half up; combinational.
//
// Made by glint-gen from cmodel/; `make generate` makes it anew.
`default_nettype none

module newton_rom (
    input  wire [6:0] m,
    output reg  [9:0] seed
);
    always @*
        case (m)
            7'd0   : seed = 10'd1020;
            7'd1   : seed = 10'd1012;
            7'd2   : seed = 10'd1004;
            7'd3   : seed = 10'd997;
            7'd4   : seed = 10'd989;
            7'd5   : seed = 10'd982;
            7'd6   : seed = 10'd975;
            7'd7   : seed = 10'd967;
            7'd8   : seed = 10'd960;
            7'd9   : seed = 10'd953;
            7'd10  : seed = 10'd946;
            7'd11  : seed = 10'd940;
            7'd12  : seed = 10'd933;
            7'd13  : seed = 10'd926;
            7'd14  : seed = 10'd920;
            7'd15  : seed = 10'd913;
            7'd16  : seed = 10'd907;
            7'd17  : seed = 10'd901;
            7'd18  : seed = 10'd895;
            7'd19  : seed = 10'd889;
            7'd20  : seed = 10'd883;
            7'd21  : seed = 10'd877;
            7'd22  : seed = 10'd871;
            7'd23  : seed = 10'd865;
            7'd24  : seed = 10'd859;
            7'd25  : seed = 10'd854;
            7'd26  : seed = 10'd848;
            7'd27  : seed = 10'd843;
            7'd28  : seed = 10'd838;
            7'd29  : seed = 10'd832;
            7'd30  : seed = 10'd827;
            7'd31  : seed = 10'd822;
            7'd32  : seed = 10'd817;
            7'd33  : seed = 10'd812;
            7'd34  : seed = 10'd807;
            7'd35  : seed = 10'd802;
            7'd36  : seed = 10'd797;
            7'd37  : seed = 10'd792;
            7'd38  : seed = 10'd787;
            7'd39  : seed = 10'd783;
            7'd40  : seed = 10'd778;
            7'd41  : seed = 10'd773;
            7'd42  : seed = 10'd769;
            7'd43  : seed = 10'd764;
            7'd44  : seed = 10'd760;
            7'd45  : seed = 10'd755;
            7'd46  : seed = 10'd751;
            7'd47  : seed = 10'd747;
            7'd48  : seed = 10'd743;
            7'd49  : seed = 10'd738;
            7'd50  : seed = 10'd734;
            7'd51  : seed = 10'd730;
            7'd52  : seed = 10'd726;
            7'd53  : seed = 10'd722;
            7'd54  : seed = 10'd718;
            7'd55  : seed = 10'd714;
            7'd56  : seed = 10'd710;
            7'd57  : seed = 10'd707;
            7'd58  : seed = 10'd703;
            7'd59  : seed = 10'd699;
            7'd60  : seed = 10'd695;
            7'd61  : seed = 10'd692;
            7'd62  : seed = 10'd688;
            7'd63  : seed = 10'd684;
            7'd64  : seed = 10'd681;
            7'd65  : seed = 10'd677;
            7'd66  : seed = 10'd674;
            7'd67  : seed = 10'd670;
            7'd68  : seed = 10'd667;
            7'd69  : seed = 10'd664;
            7'd70  : seed = 10'd660;
            7'd71  : seed = 10'd657;
            7'd72  : seed = 10'd654;
            7'd73  : seed = 10'd650;
            7'd74  : seed = 10'd647;
            7'd75  : seed = 10'd644;
            7'd76  : seed = 10'd641;
            7'd77  : seed = 10'd638;
            7'd78  : seed = 10'd635;
            7'd79  : seed = 10'd632;
            7'd80  : seed = 10'd629;
            7'd81  : seed = 10'd626;
            7'd82  : seed = 10'd623;
            7'd83  : seed = 10'd620;
            7'd84  : seed = 10'd617;
            7'd85  : seed = 10'd614;
            7'd86  : seed = 10'd611;
            7'd87  : seed = 10'd608;
            7'd88  : seed = 10'd605;
            7'd89  : seed = 10'd603;
            7'd90  : seed = 10'd600;
            7'd91  : seed = 10'd597;
            7'd92  : seed = 10'd594;
            7'd93  : seed = 10'd592;
            7'd94  : seed = 10'd589;
            7'd95  : seed = 10'd586;
            7'd96  : seed = 10'd584;
            7'd97  : seed = 10'd581;
            7'd98  : seed = 10'd579;
            7'd99  : seed = 10'd576;
            7'd100 : seed = 10'd574;
            7'd101 : seed = 10'd571;
            7'd102 : seed = 10'd569;
            7'd103 : seed = 10'd566;
            7'd104 : seed = 10'd564;
            7'd105 : seed = 10'd561;
            7'd106 : seed = 10'd559;
            7'd107 : seed = 10'd557;
            7'd108 : seed = 10'd554;
            7'd109 : seed = 10'd552;
            7'd110 : seed = 10'd550;
            7'd111 : seed = 10'd547;
            7'd112 : seed = 10'd545;
            7'd113 : seed = 10'd543;
            7'd114 : seed = 10'd541;
            7'd115 : seed = 10'd538;
            7'd116 : seed = 10'd536;
            7'd117 : seed = 10'd534;
            7'd118 : seed = 10'd532;
            7'd119 : seed = 10'd530;
            7'd120 : seed = 10'd527;
            7'd121 : seed = 10'd525;
            7'd122 : seed = 10'd523;
            7'd123 : seed = 10'd521;
            7'd124 : seed = 10'd519;
            7'd125 : seed = 10'd517;
            7'd126 : seed = 10'd515;
            7'd127 : seed = 10'd513;
        endcase
endmodule

`default_nettype wire
