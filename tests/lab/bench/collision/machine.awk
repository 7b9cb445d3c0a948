# Where and when.

END { print "Measured " machine "." }
