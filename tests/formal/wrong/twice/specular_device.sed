# A result stays valid: it is given again and again.
s/out_valid <= s3_valid;/out_valid <= s3_valid | out_valid;/
