# What pages of the manual consist of, in man(7), as man, groff and mandoc read it.

# A text of which no letter is taken for a request or another letter: a minus for a
# hyphen, a straight quote for a curly one. Before what is neither & nor another of
# its kind a backslash of a replacement is itself, in every awk.
function roff(text) {
  gsub(/\\/, "\\e", text)
  gsub(/-/, "\\-", text)
  gsub(/'/, "\\(aq", text)
  gsub(/`/, "\\(ga", text)
  gsub(/\^/, "\\(ha", text)
  gsub(/~/, "\\(ti", text)
  gsub(/"/, "\\(dq", text)
  return text ~ /^\./ ? "\\&" text : text
}
# As it is typed, and as what it stands for is typed.
function bold(text) { return "\\fB" roff(text) "\\fR" }
function italic(text) { return "\\fI" roff(text) "\\fR" }

function title(page, section, version, text) {
  printf ".TH %s %s \"\" \"brachisto %s\"\n.nh\n.SH NAME\n%s \\- %s\n",
    roff(toupper(page)), section, roff(version), roff(page), roff(text)
}
function entry(head, text) { return ".TP\n" head "\n" roff(text) ".\n" }
