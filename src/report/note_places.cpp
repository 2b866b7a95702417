// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/note_places.hpp"

#include <algorithm>

#include "report/letters.hpp"
#include "report/rich_text.hpp"

namespace brachisto::report {

namespace {

constexpr double kSize = 13.0;  // of letters [px]
constexpr double kMark = 6.0;   // half of one, with some air [px]

struct Rectangle {
  double left, right, top, bottom;

  [[nodiscard]] bool meets(const Rectangle& other) const {
    return left < other.right && other.left < right && top < other.bottom &&
           other.top < bottom;
  }
};

/// Words with their middle at this height, to the right of x for dx > 0.
Rectangle words_at(const Note& note, double x, double y) {
  const double width = width_of(letters(plain_words(note.text)), kSize);
  const double begin = note.dx < 0.0 ? x + note.dx - width : x + note.dx;
  const double middle = y + note.dy;
  return {begin, begin + width, middle - 0.6 * kSize, middle + 0.6 * kSize};
}

/// Shifts of words from the nearest to the farthest [px].
std::vector<Datum> shifts() {
  constexpr double kBeside = 9.0, kLine = 8.0;
  constexpr int kLines = 14;
  std::vector<Datum> out;
  for (int line = 0; line <= kLines; ++line) {
    for (const double dy : {-kLine * line, kLine * line}) {
      out.push_back({kBeside, dy});
      out.push_back({-kBeside, dy});
    }
  }
  return out;
}

}  // namespace

std::vector<Note> apart(std::vector<Note> notes, const PlotPixels& plot) {
  const auto [left, right] = std::minmax(plot.x.from, plot.x.to);
  const auto [top, bottom] = std::minmax(plot.y.from, plot.y.to);
  std::vector<Rectangle> taken;
  for (const Note& note : notes) {
    const double x = plot.x(note.at.x), y = plot.y(note.at.y);
    taken.push_back({x - kMark, x + kMark, y - kMark, y + kMark});
  }
  for (Note& note : notes) {
    const double x = plot.x(note.at.x), y = plot.y(note.at.y);
    for (const Datum& shift : shifts()) {
      Note moved = note;
      moved.dx = shift.x;
      moved.dy = shift.y;
      const Rectangle words = words_at(moved, x, y);
      const bool inside = words.left >= left && words.right <= right &&
                          words.top >= top && words.bottom <= bottom;
      if (!inside || std::ranges::any_of(taken, [&](const Rectangle& other) {
            return words.meets(other);
          })) {
        continue;
      }
      note = std::move(moved);
      taken.push_back(words);
      break;
    }
  }
  return notes;
}

}  // namespace brachisto::report
