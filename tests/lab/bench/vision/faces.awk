# picture,shows,pose,persons,faces,anywhere,outlines,eyes,turn,left,top,right,bottom,face_ms,map_ms,MB

function median(values, n,    i, j, v) {
    for (i = 2; i <= n; i++) {
        v = values[i]
        for (j = i - 1; j > 0 && values[j] > v; j--) values[j + 1] = values[j]
        values[j + 1] = v
    }
    return values[int((n + 1) / 2)]
}

function row(title, key) { printf "| %s | %d | %d | %d | %d |\n", title, all[key], boxed[key], found[key], anywhere[key] }

function add(key) {
    all[key]++
    if ($4 > 0) boxed[key]++
    if ($5 > 0) found[key]++
    if ($6 > 0) anywhere[key]++
}

NR == 1 { next }

{
    add($2)
    if ($2 == "face") add($3)
    if ($2 == "face" && $5 > 0) {
        face_ms[++n] = $14
        map_ms[n] = $15
    }
    if ($16 > most) most = $16
}

END {
    print "| pictures of | in all | with a person by NanoDet | with a face | with one, if all of it were a person |"
    print "|---|---:|---:|---:|---:|"
    row("a face", "face")
    row("&nbsp; from the front", "frontal")
    row("&nbsp; turned to the left", "left")
    row("&nbsp; turned to the right", "right")
    row("&nbsp; in profile", "profile")
    row("&nbsp; tilted", "tilted")
    row("&nbsp; looking down", "down")
    row("**no face**", "none")
    row("persons that are small, hidden, turned away or many", "person")
    row("statues, masks, painted eyes", "made")
    printf "\nIn words: %d of %d faces are found, and %d in %d pictures without one. To find the faces of a portrait takes %.0f ms, its map %.0f ms (medians); all four networks, %d MB. Measured %s.\n", \
        found["face"], all["face"], found["none"], all["none"], median(face_ms, n), median(map_ms, n), most, machine
}
