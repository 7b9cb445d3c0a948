# Replaces the text between `<!-- bench:NAME -->` and `<!-- /bench -->` by the file tables/NAME.md; leaves
# it as it is where there is no such file.

/^<!-- \/bench -->$/ { is_replaced = 0 }

!is_replaced { print }

/^<!-- bench:[a-z-]+ -->$/ {
    file = $0
    gsub(/^<!-- bench:| -->$/, "", file)
    file = tables "/" file ".md"
    while ((getline line < file) > 0) {
        print line
        is_replaced = 1
    }
    close(file)
}
