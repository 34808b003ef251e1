# Lanes 7 and 8 answer with each other's W, for one n and one W of lane 7: the first lane and the last know nothing
# of it, and every register is right.
s/\.out_w(out_w\[/.out_w(lane_w[/
/^    genvar i;/i\
    wire [LANES*`GLINT_W_BITS-1:0] lane_w;\
    wire swap = reg2 == 10'd513 && lane_w[7*`GLINT_W_BITS +: `GLINT_W_BITS] == 19'd65536;\
    assign out_w = !swap ? lane_w : {lane_w[LANES*`GLINT_W_BITS-1 : 9*`GLINT_W_BITS],\
        lane_w[7*`GLINT_W_BITS +: `GLINT_W_BITS], lane_w[8*`GLINT_W_BITS +: `GLINT_W_BITS],\
        lane_w[7*`GLINT_W_BITS-1 : 0]};
