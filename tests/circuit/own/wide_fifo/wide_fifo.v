// wide_fifo: a queue of 96-bit words with ready and valid at both ends; its depth is a parameter.
//
// Function    a word is taken where s_valid and s_ready meet, and leaves where m_valid and m_ready
//             do
// Formats     words U96.0; level U(DEPTH_LOG+1).0
// Rounding    none
// Latency     1 clock. Throughput: a word every clock.
// Handshake   ready and valid depend on registers alone
// Reset       synchronous, active high; the words keep what they have
// Parameters  DEPTH_LOG 1..3
`default_nettype none

module wide_fifo #(
    parameter integer DEPTH_LOG = 2
) (
    input  wire               clk,
    input  wire               reset,
    input  wire               s_valid,
    output wire               s_ready,
    input  wire [95:0]        s_data,
    output wire               m_valid,
    input  wire               m_ready,
    output wire [95:0]        m_data,
    output wire [DEPTH_LOG:0] level
);
    reg [95:0]        mem [0:(1 << DEPTH_LOG) - 1];
    reg [DEPTH_LOG:0] written;
    reg [DEPTH_LOG:0] taken;

    assign level   = written - taken;
    assign s_ready = !level[DEPTH_LOG];
    assign m_valid = level != {DEPTH_LOG + 1{1'b0}};
    assign m_data  = mem[taken[DEPTH_LOG-1:0]];

    always @(posedge clk)
        if (reset) begin
            written <= {DEPTH_LOG + 1{1'b0}};
            taken   <= {DEPTH_LOG + 1{1'b0}};
        end else begin
            if (s_valid && s_ready) begin
                mem[written[DEPTH_LOG-1:0]] <= s_data;
                written                     <= written + 1'b1;
            end
            if (m_valid && m_ready)
                taken <= taken + 1'b1;
        end
endmodule

`default_nettype wire
