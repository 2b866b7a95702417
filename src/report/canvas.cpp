// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/canvas.hpp"

#include <algorithm>
#include <cmath>

#include "report/letters.hpp"
#include "report/rich_text.hpp"

namespace brachisto::report {

namespace {

/// Commands that lay out the ticks of an axis.
std::string tics(char name, const Side& side, const Extent& range) {
  constexpr double kManyDegrees = 240.0, kFewDegrees = 60.0, kDecades = 1e3;
  const double span = range.width();
  if (!side.words.empty()) {
    std::string out;
    for (std::size_t i = 0; i < side.words.size(); ++i) {
      constexpr std::size_t kLetters = 18;
      out +=
          fmt::format("{}'{}' {}", i == 0 ? "" : ", ",
                      gnuplot_escaped(shortened(side.words[i], kLetters)), i);
    }
    return fmt::format("set {}tics ({}){}\n", name, out,
                       side.slanted() ? " rotate by -30" : "");
  }
  switch (side.scale) {
    case Scale::Linear:
      break;
    case Scale::Degrees:
      if (span < kFewDegrees) break;
      return fmt::format("set {}tics {}\n", name,
                         span > kManyDegrees ? 90 : 30);
    case Scale::Logarithmic:
      if (range.high > kDecades * range.low) {
        return fmt::format("set logscale {0}\nset format {0} '10^{{%L}}'\n",
                           name);
      }
      // Of few decades also what is between them.
      return fmt::format(
          "set logscale {0}\nset format {0} '%g'\n"
          "set for [e={1:.0f}:{2:.0f}] {0}tics add (2*10.**e, 5*10.**e)\n",
          name, std::floor(std::log10(range.low)),
          std::floor(std::log10(range.high)));
  }
  return fmt::format("set format {} '%g'\n", name);
}

}  // namespace

std::string quoted_words(std::string_view source) {
  return "'" + gnuplot_words(source) + "'";
}

bool Side::slanted() const {
  constexpr std::size_t kLetters = 80;
  std::size_t longest = 0;
  for (const std::string& word : words) {
    longest = std::max(longest, letters(word));
  }
  return longest * words.size() > kLetters;
}

void Canvas::open(const Layout& layout, const std::string& title,
                  const std::string& subtitle, int key_rows) {
  constexpr double kTitle = 24.0, kSubtitle = 18.0;  // [px]
  constexpr double kKeyLine = 19.5, kBelow = 10.0;
  constexpr std::size_t kLetters = 94;  // of a line across the picture
  const std::vector<std::string> lines = subtitle.empty()
                                             ? std::vector<std::string>()
                                             : lines_of(subtitle, kLetters);
  double y = title.empty() ? 0.0 : kTitle;
  left_ = layout.left;
  right_ = width - layout.right;
  top_ = layout.above + y + kSubtitle * static_cast<double>(lines.size());
  bottom_ = top_ + layout.height;
  height = bottom_ + layout.to_key + kKeyLine * key_rows + kBelow;
  title_ = plain_words(title + (subtitle.empty() ? "" : ": ") + subtitle);
  std::swap(head_, text_);
  put("set border 15 lw 1 lc rgb '#333333'\nset tics out nomirror\n");
  frame(left_, top_, right_ - left_, layout.height);
  put("set key at screen {:.5f}, screen {:.5f} {} top vertical Left reverse "
      "samplen {} maxrows {}\n",
      layout.key_at / width, 1.0 - (bottom_ + layout.to_key) / height,
      layout.key_side, layout.sample, std::max(1, key_rows));
  if (!title.empty()) words(title, layout.title_left, y, "font ',15'");
  for (const std::string& line : lines) {
    words(line, layout.title_left, y += kSubtitle, "textcolor rgb '#444444'");
  }
  std::swap(head_, text_);
}

void Canvas::axis(char name, const Side& side, const Extent& range, bool down) {
  const auto [first, last] = down ? std::pair{range.high, range.low}
                                  : std::pair{range.low, range.high};
  (name == 'x' ? x_ : y_) = {first, last, name == 'x' ? left_ : bottom_,
                             name == 'x' ? right_ : top_,
                             side.scale == Scale::Logarithmic};
  head_ += fmt::format(
      "set {0}label {1}\nset {0}range [{2:.12g}:{3:.12g}] noextend\n{4}", name,
      quoted_words(side.label), first, last, tics(name, side, range));
}

void Canvas::frame(double left, double top, double wide, double high) {
  put("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
      "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
      left / width, (left + wide) / width, 1.0 - top / height,
      1.0 - (top + high) / height);
}

void Canvas::words(const std::string& text, double x, double y,
                   std::string_view style) {
  put("set label {} at screen {:.5f}, screen {:.5f} {}\n", quoted_words(text),
      x / width, 1.0 - y / height, style);
}

void Canvas::layer(std::string_view item, const std::string& name) {
  layers_ +=
      fmt::format("{}{} {}", layers_.empty() ? "" : ", \\\n  ", item,
                  name.empty() ? "notitle" : "title " + quoted_words(name));
}

void Canvas::plot(std::string_view command, std::string_view nothing) {
  if (layers_.empty()) layer(nothing);
  put("{} {}\n", command, std::exchange(layers_, {}));
}

Figure Canvas::figure(std::string name, std::string table) && {
  return {.name = std::move(name),
          .table = std::move(table),
          .commands = head_ + text_,
          .width = width,
          .height = height,
          .title = std::move(title_)};
}

}  // namespace brachisto::report
