// ring: a queue of four signed bytes, with the sum of all that were taken.
//
// Function    push puts data at the end if there is room, pop takes the front away if there is one
// Formats     data, front S8.0;  sum S16.0, wraps
// Rounding    none
// Latency     1 clock from the edge that takes data to the one after which it may be in front
// Handshake   taken and full are combinational: taken = 1 says that the next edge takes data.
//             A push into a full ring is taken when it is popped at the same edge. No enable.
// Reset       asynchronous, active low
// Parameters  none
`default_nettype none

module ring (
    input  wire              clock,
    input  wire              rst_n,
    input  wire              push,
    input  wire              pop,
    input  wire signed [7:0] data,
    output wire              taken,
    output wire              full,
    output wire signed [7:0] front,
    output reg  [2:0]        level
);
    reg signed [7:0] mem [0:3];
    reg [1:0]        head;

    wire       gone = pop && level != 3'd0;
    wire [1:0] tail = head + level[1:0];

    assign full  = level == 3'd4;
    assign taken = push && (!full || gone);
    assign front = mem[head];

    integer i;
    always @(posedge clock or negedge rst_n)
        if (!rst_n) begin
            head  <= 2'd0;
            level <= 3'd0;
            for (i = 0; i < 4; i = i + 1) mem[i] <= 8'sd0;
        end else begin
            if (gone) head <= head + 2'd1;
            if (taken) mem[tail] <= data;
            level <= level + {2'b00, taken} - {2'b00, gone};
        end

    ring_sum u_sum (.clock(clock), .rst_n(rst_n), .taken(taken), .data(data));
endmodule

// ring_sum: a sum that only its owner sees.
module ring_sum (
    input  wire              clock,
    input  wire              rst_n,
    input  wire              taken,
    input  wire signed [7:0] data
);
    reg signed [15:0] acc;

    always @(posedge clock or negedge rst_n)
        if (!rst_n)     acc <= 16'sd0;
        else if (taken) acc <= acc + {{8{data[7]}}, data};
endmodule

`default_nettype wire
