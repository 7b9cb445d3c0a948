# What of the goals is reached, out of what opening_bench prints.

function least(cell) { return cell + 0 }  # "52.8 (55.3)": least (median)

function goal(words, most_ms, ms, of) {
    if (ms > 0) printf "| %s | %.0f | %.1f%s | %s |\n", words, most_ms, ms, of, ms <= most_ms ? "yes" : "no"
    else printf "| %s | %.0f | not measured | no |\n", words, most_ms
}

BEGIN { FS = " *[|] *" }

/worker's start, to a refusal/ { sub(/.*: /, ""); start_ms = least($0) }

/^[|] [^ ]+[.]/ {
    opened_ms[$2] = least($4)
    if ($5 != "-" && $7 != "-") felt_ms[$2] = least($4) + least($5) + least($7)
    if ($6 != "-" && least($5) - least($6) > worker_ms) worker_ms = least($5) - least($6)
}

END {
    print "| goal | at most, ms | reached, ms | met |\n|---|---|---|---|"
    goal("a worker's start, to a refusal", 5, start_ms, "")
    goal("a PNG of 1 megapixel, to pixels", 40, opened_ms["one-megapixel.png"], " of noise")
    goal("a scanned page of 2 megapixels, to pixels", 40, opened_ms["scanned-page.png"], "")
    goal("a JPEG of 12 megapixels, to a felt outline", 1000, felt_ms["twelve-megapixels.jpg"], " of noise")
    goal("a page of a PDF, to a felt outline", 600, felt_ms["page.pdf"], "")
    goal("lines found by a worker, more than without one", 10, worker_ms, " at most")
    longest = 0
    for (file in opened_ms) if (opened_ms[file] > longest) longest = opened_ms[file]
    printf "\nIn words: every file is opened in less than %.0f ms.\n", longest + 1
}
