# The slack of a netlist's slowest path between two registers in 100 ns: OpenSTA, no wires.
read_liberty $::env(LIBERTY)
read_verilog netlist.v
link_design compare_unit
create_clock -name clk -period 100 [get_ports clk]
report_worst_slack
