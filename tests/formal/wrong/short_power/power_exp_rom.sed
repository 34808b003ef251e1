# ROM 33 begins a code below 1.0.
s/8'd0  : power = 13'd4096/8'd0  : power = 13'd4095/
