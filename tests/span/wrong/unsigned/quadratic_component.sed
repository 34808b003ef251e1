# A level below 0 is held at 255, as one above.
s/level\[I\] ? {C{1'b0}} : above/level[I] || above/
