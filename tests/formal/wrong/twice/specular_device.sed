# A result stays valid: it is given again and again.
s/\.d(s3_valid)/.d(s3_valid | out_valid)/
