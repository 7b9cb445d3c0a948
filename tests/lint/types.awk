# The types that sources define in a namespace with a name: a name that two files define is told where the second stands.
# A linker takes one of two, and the functions of std::vector<T> for both.
FNR == 1 { depth = 0 }
/^namespace [a-z_:]+ \{/ { inside[++depth] = $2; next }
/^namespace \{/ { inside[++depth] = "{"; next }
/^\}  \/\/ namespace/ { depth -= depth > 0; next }
/^(struct|class|union|enum class) [A-Za-z]/ && !/;[ \t]*$/ {
    name = $1 == "enum" ? $3 : $2
    sub(/[:{].*/, "", name)
    if ($0 ~ name "::") next # a part of a type that is defined elsewhere
    for (i = depth; i > 0; --i) {
        if (inside[i] == "{") next
        name = inside[i] "::" name
    }
    if (name in defined && defined[name] != FILENAME) print FILENAME ":" FNR ": " name " is defined in " defined[name] " too"
    else defined[name] = FILENAME
}
