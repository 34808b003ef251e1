# done comes one clock late.
s/reg        \[LEFT-1:0\] .*left;/&  reg late;/
s/done     <= (left == LAST);/done     <= 1'b0; late <= (left == LAST);/
s/done <= 1'b0;/done <= late; late <= 1'b0;/
