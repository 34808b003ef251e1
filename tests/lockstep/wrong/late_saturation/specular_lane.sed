# Register 1 saturates one code late: 1.0 and one code goes in as it is.
s/(cos > COS_ONE) ? COS_ONE/(cos > COS_ONE + 1) ? COS_ONE/
