# What the hand felt in each part of a demonstration.

FNR > 2 {
    row = "| " field("demo") ": " field("phase") " | " field("mean_N") " | " field("most_N") " | " field("most_mNm") " | " \
        field("x_mm") ", " field("y_mm") " | " field("angle_deg") " |"
    rows[++count] = row
    most[field("demo") ":" field("phase")] = field("most_N")
    torque[field("demo") ":" field("phase")] = field("most_mNm")
    y[field("demo") ":" field("phase")] = field("y_mm")
}

END {
    print "| what the hand does | force, mean (N) | most (N) | torque, most (mNm) | shape at its end (mm) | angle (degrees) |"
    print rule(5)
    for (i = 1; i <= count; i++) print rows[i]
    printf "\nIn words: the peg slides on the surface at %s N, falls into the slot to %s mm and resists a twist of 25 degrees by %s mNm.\n", \
        most["peg:slides to the slot"], y["peg:goes in"], torque["peg:twists inside"]
    printf "The key goes through the hole sideways, hooks behind the wall, holds a pull of %s N without giving way and meets its stop at %s N.\n", \
        most["key:pulls on"], most["key:pushes to the stop"]
}
