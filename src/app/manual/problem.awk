# The page of problem files from the table of keys in their documentation:
#   awk -v version=0.1.0 -f roff.awk -f problem.awk docs/problem-files.md

BEGIN {
  FS = " *[|] *"
  title("brachisto-problem", 5, version, "which body rolls where, and how its track is computed")
  print ".SH DESCRIPTION"
  print "A problem file is a YAML document. The shortest one, in which all else has"
  print "its default, is\n.PP\n.nf\nscene: {body: {shape: bead}, finish: {L: 3, H: 1}}\n.fi\n.PP"
  print "Below, scene.finish.L is the key L of the map finish in the map scene."
  print "Numbers may be expressions of constants, as 1/3 or sqrt(1\\-0.5), angles in"
  print "radians or, as \\-30 deg, in degrees. What is not listed is a mistake, and so"
  print "are values out of their bounds.\n.SH KEYS"
}

/^[|] key [|] type/ { inside = 1 }
/^$/ { inside = 0 }

# Key, type, unit, default, allowed, meaning.
inside && /^[|] `/ {
  gsub(/`, `/, " or ")
  gsub(/`/, "")
  while (match($0, /\[[^]]*\]\(#[^)]*\)/)) {  # a link within the page
    link = substr($0, RSTART + 1, RLENGTH - 1)
    sub(/\].*/, " in docs/problem-files.md", link)
    $0 = substr($0, 1, RSTART - 1) link substr($0, RSTART + RLENGTH)
  }
  text = $7
  if ($4 != "") text = text " [" $4 "]"
  if ($6 != "") text = text "; " $6
  of_cylinder = sub(/ ?\(cylinder\)$/, "", $5)
  if ($5 == "required") text = text "; required" (of_cylinder ? " of a cylinder" : "")
  else if ($5 != "" && $5 != "—") text = text "; default: " $5
  if ($2 !~ /\./) print ".SS " roff($2)
  printf "%s", entry(bold($2) " (" $3 ")", text)
}

END {
  print ".SH EXAMPLES\nbrachisto new writes a file with comments to begin with:\n.PP\n.nf"
  print "brachisto new track\nbrachisto solve track.yaml\n.fi\n.SH SEE ALSO\n.BR brachisto (1),"
  print ".BR brachisto\\-new (1),\n.BR brachisto\\-validate (1),\n.BR brachisto\\-schema (1)"
}
