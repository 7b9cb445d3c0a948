# The emulator's log of executed blocks (-d exec,in_asm,nochain) -> instructions of each servo step,
# a line each. `first` is where the step begins, `returns` where its callers go on: hexadecimal,
# without zeros in front, with blanks between.
BEGIN { split(returns, list, " "); for (i in list) is_return[list[i]] = 1 }

# A block as translated: its instructions, a line each, the first with its address.
/^0x/ {
    if (is_new) { block = substr($1, 3); sub(/:$/, "", block); size[block] = 0; is_new = 0 }
    size[block]++
    next
}
/^IN:/ { is_new = 1; next }

/^Trace/ {
    split($4, part, "/")
    at = part[2]
    sub(/^0+/, "", at)
    if (!(at in size)) { print "a block that was never translated: " at >"/dev/stderr"; exit 1 }
    if (at == first) { is_in = 1; sum = 0 }
    else if (is_in && at in is_return) { print sum; is_in = 0 }
    if (is_in) sum += size[at]
}
