-- SPDX-FileCopyrightText: 2026 The brachisto authors
-- SPDX-License-Identifier: MIT
-- What GitHub makes of a page and pandoc does not: blocks of mathematics, links between pages.

function CodeBlock(block)
  if block.classes[1] == "math" then
    return pandoc.Para{pandoc.Math("DisplayMath", block.text)}
  end
end

function Math(math)
  -- MathML has no equation numbers.
  math.text = math.text:gsub("\\tag(%b{})", function(tag)
    return "\\qquad(" .. tag:sub(2, -2):gsub("–", "\\text{–}") .. ")"
  end)
  return math
end

function Link(link)
  link.target = link.target:gsub("%.md$", ".html"):gsub("%.md#", ".html#")
  return link
end

function Pandoc(page)
  local first = page.blocks[1]
  page.meta.pagetitle = first.t == "Header" and pandoc.utils.stringify(first) or "brachisto"
  return page
end
