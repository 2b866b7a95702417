# The table of a sweep without the column of seconds, the only one that may
# differ between runs. To be sourced; $brachisto is the program.
table() {
  "$brachisto" export "$1" --csv 2>/dev/null |
    awk -F, -v OFS=, 'NR == 1 {
        for (i = 1; i <= NF; i++) if ($i == "seconds.total") skip = i
      } { $skip = ""; print }'
}
