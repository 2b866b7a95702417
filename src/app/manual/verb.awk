# The page of a verb from its help, and that of the command from its own:
#   brachisto solve --help | awk -v page=brachisto-solve -v version=0.1.0 -f roff.awk -f verb.awk

# Takes the sentence behind a word, such as "Needs: --out", out of the head of an option.
function behind(word, sentence,    what) {
  if (!match(head, word ": [^ ]+")) return ""
  what = substr(head, RSTART + length(word) + 2, RLENGTH - length(word) - 2)
  head = substr(head, 1, RSTART - 1) substr(head, RSTART + RLENGTH)
  return ". " sentence " " what
}

# The entry of the option that was read: its head, "--jobs N:INT in [1 - 8]=2 REQUIRED", and
# its text, behind column 30 or in a line of its own.
function end_option(    name, kind, allowed, more, required, shown) {
  if (head == "") return
  if (text == "") {
    text = substr(head, 31)
    head = substr(head, 1, 30)
  }
  more = behind("Needs", "Needs") behind("Excludes", "Not with")
  required = sub(/ REQUIRED/, "", head)
  if (sub(/ \.\.\./, "", head) || head ~ /KEY=VALUE/) more = ". May be given again and again" more
  sub(/^ +(-h,)?/, "", head)
  sub(/ +$/, "", head)
  name = head
  sub(/ .*/, "", name)
  kind = substr(head, length(name) + 2)
  if (kind != "KEY=VALUE" && match(kind, /=[^=]*$/)) {
    more = ". Default: " substr(kind, RSTART + 1) more
    kind = substr(kind, 1, RSTART - 1)
  }
  if (match(kind, /:[{I].*/)) {
    allowed = substr(kind, RSTART + 1)
    if (gsub(/[{}]/, "", allowed)) gsub(/,/, " or ", allowed)
    sub(/^INT in \[/, "an integer from ", allowed)
    sub(/ - /, " to ", allowed)
    sub(/\]$/, "", allowed)
    more = ". Expected: " allowed more
  }
  sub(/:.*/, "", kind)
  if (name ~ /^-/) {
    shown = bold(name) (kind == "" ? "" : " " italic(kind))
    if (group) choices = choices (choices == "" ? "" : " | ") shown
    if (required) synopsis = synopsis " " shown
  } else {
    shown = italic(name)
  }
  options = options entry(shown, text more)
  head = text = ""
}

function end_paragraph() {
  if (paragraph != "") description = description ".PP\n" roff(paragraph) "\n"
  paragraph = ""
}

/^Usage: / {
  what = about
  about = ""
  split(substr($0, 8), usage, / \[OPTIONS\]/)
  gsub(/[A-Z]+/, "\\fI&\\fR", usage[2])
  sub(/\.\.\./, " ...", usage[2])
  synopsis = bold(usage[1]) " [options]" usage[2]
  next
}
synopsis == "" { about = about (about == "" ? "" : " ") $0; next }
part != "end" && /^ *$/ { next }
part != "end" && /^(Positionals|  Options|Options|Subcommands):$/ { end_option(); part = $1; next }
part != "end" && /^\[Option Group|^  \[Exactly/ { end_option(); group = 1; next }
part == "Subcommands:" && /^  / {
  verbs = verbs entry(bold($1), substr($0, 31) "; see brachisto-" $1 "(1)")
  also = also ",\n.BR brachisto\\-" roff($1) " (1)"
  next
}
part != "end" && /^                              / { text = substr($0, 31); next }
part != "end" && /^ / {
  end_option()
  head = group ? substr($0, 3) : $0
  next
}
{ end_option(); part = "end" }

# Behind all options: paragraphs, each with lines that stand as they are, examples, exit codes.
/^Examples?:$/ { end_paragraph(); in_examples = 1; next }
/^  / && in_examples { examples = examples roff(substr($0, 3)) "\n"; next }
/^  / {
  end_paragraph()
  description = description (in_lines ? "" : ".PP\n.nf\n") roff(substr($0, 3)) "\n"
  in_lines = 1
  next
}
in_lines { description = description ".fi\n"; in_lines = 0 }
sub(/^Exit codes: /, "") { end_paragraph(); exit_status = $0; next }
exit_status != "" { exit_status = exit_status " " $0; next }
{ in_examples = 0; paragraph = paragraph (paragraph == "" ? "" : " ") $0 }

END {
  end_option()
  end_paragraph()
  if (in_lines) description = description ".fi\n"
  front = page == "brachisto"
  title(page, 1, version, front ? "smooth-contact extremals of rolling bodies" : what)
  if (front) {
    print ".SH SYNOPSIS\n" bold(page) " " italic("VERB") " [options]"
    print ".br\n" bold(page) " " italic("VERB") " " bold("--help")
    print ".br\n" bold(page) " " bold("--help") " | " bold("--version")
    print ".SH DESCRIPTION\n" roff(what) "\n.SH VERBS"
    printf "%s", verbs
  } else {
    print ".SH SYNOPSIS\n" synopsis (choices == "" ? "" : " {" choices "}")
    print ".SH DESCRIPTION\n" roff(what) "."
    printf "%s", description
  }
  if (front) {
    options = options entry(bold("--color") " " italic("WHEN"), \
                            "Of every verb: whether there are colours; see brachisto-solve(1)")
  }
  printf ".SH OPTIONS\n%s", options
  if (examples != "") printf ".SH EXAMPLES\n.nf\n%s.fi\n", examples
  if (exit_status != "") print ".SH EXIT STATUS\n" roff(exit_status)
  if (front) {
    printf ".SH ENVIRONMENT\n%s%s",
      entry(bold("NO_COLOR"), "If it is set and not empty, there are no colours unless " \
                              "--color always asks for them"),
      entry(bold("TERM"), "\"dumb\": there are no colours either")
  }
  print ".SH SEE ALSO"
  print (front ? "" : ".BR brachisto (1),\n") ".BR brachisto\\-problem (5)" also
}
