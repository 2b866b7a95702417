// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Pages of the manual in man(7), what man, groff and mandoc read.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brachisto::app {

/// A text in roff, of which no letter is taken for a request or another letter.
[[nodiscard]] std::string roff(std::string_view text);

/// The same, as it is typed, and as what it stands for is typed.
[[nodiscard]] std::string roff_bold(std::string_view text);
[[nodiscard]] std::string roff_italic(std::string_view text);

/// A page, part by part. Texts are plain, heads may be roff.
class ManualPage {
 public:
  /// \param title  "brachisto-solve"
  /// \param text   "Solve a scene", behind the name
  ManualPage(std::string_view title, int section, std::string_view version,
             std::string_view text);

  ManualPage& section(std::string_view title);
  ManualPage& subsection(std::string_view title);
  /// A paragraph, in lines.
  ManualPage& paragraph(std::string_view text);
  /// Of roff.
  ManualPage& roff_line(std::string_view line);
  /// Lines as they stand.
  ManualPage& example(const std::vector<std::string>& lines);
  /// \param head  roff
  ManualPage& entry(std::string_view head, std::string_view text);

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  /// A heading begins one itself.
  void begin_paragraph();
  void fill(std::string_view text);

  std::string text_;
};

}  // namespace brachisto::app
