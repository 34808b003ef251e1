# Lanes 7 and 8 answer with each other's W, for one n and one W of lane 7.
s/\.out_w(out_w\[/.out_w(lane_w[/
/^    genvar i;/i\
    wire [LANES*W_BITS-1:0] lane_w;\
    wire swap = last_n == 10'd513 && lane_w[7*W_BITS +: W_BITS] == 1024;\
    assign out_w = !swap ? lane_w : {lane_w[LANES*W_BITS-1 : 9*W_BITS],\
        lane_w[7*W_BITS +: W_BITS], lane_w[8*W_BITS +: W_BITS], lane_w[7*W_BITS-1 : 0]};
