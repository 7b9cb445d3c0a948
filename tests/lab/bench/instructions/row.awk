# Reads "LEVEL EDGES STEP INSTRUCTIONS" of each step, sorted by instructions, then "LINES CODE DATA" of the steps with
# empty caches, sorted by lines; prints a row of the CSV file.

NR == FNR {
    row = $1 "," $2
    instructions[++steps] = $4
    next
}

{
    lines[++cold] = $1
    if ($2 > code) code = $2
    if ($3 > data) data = $3
}

END {
    if (!steps || !cold) exit 1
    print row "," steps "," instructions[int(steps / 2) + 1] "," instructions[int(steps * 0.99) + 1] "," instructions[steps] "," \
        cold "," lines[int(cold / 2) + 1] "," lines[cold] "," code "," data
}
