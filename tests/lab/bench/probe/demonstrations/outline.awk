# The corners of the paths of an .svg of these demonstrations (M, H, V, Z, absolute), millimetres, y upwards; a blank line
# between paths. Set turn (rad), x and y (mm) to place it.

match($0, / d="[^"]*"/) {
    path = substr($0, RSTART + 4, RLENGTH - 5)
    while (match(path, /[MHVLZ][-0-9., ]*/)) {
        mark = substr(path, RSTART, 1)
        split(substr(path, RSTART + 1, RLENGTH - 1), v, /[ ,]+/)
        path = substr(path, RSTART + RLENGTH)
        if (mark == "M") { if (started++) print ""; px = first_x = v[1]; py = first_y = v[2] }
        if (mark == "H") px = v[1]
        if (mark == "V") py = v[1]
        if (mark == "L") { px = v[1]; py = v[2] }
        if (mark == "Z") { px = first_x; py = first_y }
        printf "%.4f %.4f\n", x + px * cos(turn) + py * sin(turn), y + px * sin(turn) - py * cos(turn)
    }
}
