# ROM 33 holds more than 1024/3 for the last n.
s/10'd1023: sigma = 22'd[0-9]*/10'd1023: sigma = 22'd2796204/
