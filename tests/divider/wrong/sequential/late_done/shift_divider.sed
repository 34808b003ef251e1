# done comes one clock late.
s/reg        \[4:0\] .*left;/&  reg late;/
s/done     <= (left == 5'd1);/done     <= 1'b0; late <= (left == 5'd1);/
s/done <= 1'b0;/done <= late; late <= 1'b0;/
