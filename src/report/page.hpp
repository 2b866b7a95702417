// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What pages with pictures or scripts have alike.

#pragma once

#include <atomic>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/figure.hpp"
#include "report/result_texts.hpp"
#include "report/text_table.hpp"

namespace brachisto::report {

/// A page up to the beginning of its body.
/// \param title   HTML
/// \param styles  style sheets
[[nodiscard]] std::string document_head(
    const std::string& title, std::initializer_list<std::string_view> styles);

/// Bytes of pictures that a page may hold.
inline constexpr std::size_t kMostOfPictures = 4'000'000;

/// A page with pictures as it grows, and the files beside it.
class GrowingPage {
 public:
  /// \param interrupt  nonzero: stop; may be null
  explicit GrowingPage(const std::atomic<int>* interrupt)
      : interrupt_(interrupt) {}

  GrowingPage& operator+=(std::string_view html) {
    html_ += html;
    return *this;
  }
  /// Draws a picture with its caption and links to its files; one that needs
  /// more bytes than are left is shown from its file.
  /// \param caption  HTML
  /// \return whether there is a picture; if not, the page says why
  /// \throws Stopped
  bool add(const Figure& figure, const std::string& caption);
  void add_file(std::string name, std::string content) {
    out_.files.push_back({std::move(name), std::move(content)});
  }
  /// Of the next picture, "Figure 2. ".
  [[nodiscard]] std::string next_number() const;

  [[nodiscard]] const std::string& html() const { return html_; }
  [[nodiscard]] const DrawnFiles& files() const { return out_; }

 private:
  const std::atomic<int>* interrupt_;
  std::string html_;
  std::size_t room_ = kMostOfPictures;
  int pictures_ = 0;
  DrawnFiles out_;
};

/// A cell of a table: HTML, and its class.
struct HtmlCell {
  std::string html;
  std::string_view style = {};
};
using HtmlRows = std::vector<std::vector<HtmlCell>>;

/// A table of HTML, as blocks of lines on a narrow screen, where each cell is
/// told its head.
/// \param style  further class of the table
/// \param names  whether the first cell of a row is its name
[[nodiscard]] std::string html_table(const std::vector<std::string>& heads,
                                     const HtmlRows& rows,
                                     std::string_view style = "",
                                     bool names = false);
/// The same of text.
[[nodiscard]] std::string html_table(const Rows& rows);

/// What is folded until its summary is pressed.
/// \param content  HTML
/// \param open     from the start on
[[nodiscard]] std::string folded_html(std::string_view summary,
                                      const std::string& content,
                                      bool open = false);

/// A script within a page that is XML too.
[[nodiscard]] std::string script_html(std::string_view content);

/// JSON that HTML and XML leave alone.
[[nodiscard]] std::string page_json(const Json& json);

/// The JSON document from which the scripts of a page draw.
[[nodiscard]] std::string data_html(std::string_view json);

/// The controls of the time.
/// \param more  of them, HTML
[[nodiscard]] std::string playback_html(std::string_view more = {});

}  // namespace brachisto::report
