// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/cutting_assembly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "report/letters.hpp"

namespace brachisto::report::cutting {

namespace {

constexpr double kWords = SheetFrame::kLetter;  ///< [mm]

/// Rows of words below a head, and what they are.
struct Table {
  std::string caption;
  std::vector<std::vector<std::string>> rows;  ///< the first is the head
};

std::string in_mm(double length) {
  // No −0.0.
  return fmt::format("{:.1f}", std::abs(length) < 0.05 ? 0.0 : length);
}

void add_place(std::vector<std::string>& row, Point at) {
  row.push_back(in_mm(at.x));
  row.push_back(in_mm(at.z));
}

/// Of two strips both pieces have one, first all L.
std::string sheets_in_words(std::size_t piece, std::size_t pieces,
                            const std::vector<int>& sheet_of) {
  const int sheet = sheet_of[piece];
  if (sheet_of.size() == pieces) return fmt::format("{}", sheet);
  return fmt::format("{} L, {} R", sheet, sheet_of[pieces + piece]);
}

Table table_of_pieces(const Edge& edge, const std::vector<Piece>& pieces,
                      const std::vector<int>& sheet_of) {
  Table out{"Where each piece hangs: mm to the right of A (x) and below it (z)",
            {{"piece", "sheet", "edge x", "z", "to x", "z", "first hole x", "z",
              "last hole x", "z"}}};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    std::vector<std::string> row{fmt::format("{}", i + 1),
                                 sheets_in_words(i, pieces.size(), sheet_of)};
    const double middle = 0.5 * edge.strip();
    add_place(row, edge.at(piece.from).place);
    add_place(row, edge.at(piece.to).place);
    add_place(row, edge.at(piece.holes.front()).at_depth(middle));
    add_place(row, edge.at(piece.holes.back()).at_depth(middle));
    out.rows.push_back(std::move(row));
  }
  return out;
}

Table table_of_errors(const std::vector<DisplacedStretch>& stretches,
                      const Build& build) {
  Table out{"What a stretch that is 1 mm off in its middle does to the time",
            {{"from x", "to x", "too high", "too low"}}};
  for (const DisplacedStretch& stretch : stretches) {
    const auto x = [&](const TrajectoryPoint& at) {
      return in_mm(build.per_metre() * at.motion.contact.x);
    };
    out.rows.push_back({x(stretch.from), x(stretch.to),
                        change_in_words(stretch.raised),
                        change_in_words(stretch.lowered)});
  }
  return out;
}

/// Tables one below the other, on as many sheets as they take.
class TableSheets {
 public:
  TableSheets(const SheetFrame& frame, std::vector<Drawing>& sheets)
      : frame_(frame), sheets_(sheets) {}

  void add(const Table& table) {
    std::vector<std::size_t> columns;
    for (const auto& row : table.rows) {
      columns.resize(row.size());
      for (std::size_t c = 0; c < row.size(); ++c) {
        columns[c] = std::max(columns[c], letters(row[c]) + kBetween);
      }
    }
    std::size_t all = 0;
    for (const std::size_t column : columns) all += column;
    const double size =
        std::min(kWords, frame_.room().width() / width_of(all, 1.0));
    for (std::size_t r = 1; r < table.rows.size(); ++r) {
      if (r == 1 || !has_room(1)) {
        // No head without a row.
        if (!has_room(3)) begin();
        z_ += SheetFrame::kLine;
        add_words({frame_.room().low.x, z_}, kWords, table.caption);
        add_row(table.rows.front(), columns, size);
      }
      add_row(table.rows[r], columns, size);
    }
    z_ += SheetFrame::kLine;
  }

 private:
  static constexpr std::size_t kBetween = 2;  ///< letters

  [[nodiscard]] bool has_room(int lines) const {
    return begun_ && z_ + lines * SheetFrame::kLine <= frame_.room().high.z;
  }
  void begin() {
    const std::size_t number = sheets_.size() + 1;
    sheets_.push_back(frame_.sheet(fmt::format("assembly-{:02}", number),
                                   "Assembly, in numbers"));
    z_ = frame_.room().low.z;
    begun_ = true;
  }
  void add_words(Point at, double size, const std::string& words) {
    sheets_.back().shapes.labels.push_back({at, size, words});
  }
  void add_row(const std::vector<std::string>& row,
               const std::vector<std::size_t>& columns, double size) {
    z_ += SheetFrame::kLine;
    double x = frame_.room().low.x;
    for (std::size_t c = 0; c < row.size(); ++c) {
      add_words({x, z_}, size, row[c]);
      x += width_of(columns[c], size);
    }
  }

  const SheetFrame& frame_;
  std::vector<Drawing>& sheets_;
  double z_ = 0.0;
  bool begun_ = false;
};

/// The pieces as they hang, as large as there is room.
class AssemblyPicture {
 public:
  AssemblyPicture(const Edge& edge, const std::vector<Piece>& pieces,
                  const SheetFrame& frame)
      : edge_(edge), room_(frame.room()) {
    Box box = box_of(outline(edge, 0.0, edge.length(), 0.0, edge.strip()));
    // Words stand around it.
    constexpr double kAround = 4.0 * kWords;
    scale_ = std::min({1.0, (room_.width() - 2.0 * kAround) / box.width(),
                       (room_.height() - 2.0 * kAround) / box.height()});
    origin_ = {room_.low.x + kAround - scale_ * box.low.x,
               room_.low.z + kAround - scale_ * box.low.z};
    out_ = frame.sheet(
        "assembly-01",
        fmt::format("Assembly, as it hangs, {:.3g} % of the size of its parts",
                    100.0 * scale_));
    for (std::size_t i = 0; i < pieces.size(); ++i) add_piece(pieces[i], i + 1);
    add_ends();
  }

  void add_dearest(const DisplacedStretch& stretch) {
    // Above the edge, where nothing else is.
    const double above = -0.6 * kWords / scale_;
    Polyline line{Line::Engrave, {}};
    const auto along = [&](const TrajectoryPoint& at) {
      return edge_.along(at.sigma);
    };
    for (const EdgePoint& p :
         edge_.between(along(stretch.from), along(stretch.to))) {
      line.points.push_back(on_sheet(p.at_depth(above)));
    }
    out_.shapes.polylines.push_back(std::move(line));
    // Beside it on the side that is higher than the track.
    const EdgePoint middle = edge_.at(along(stretch.middle));
    const std::string words = "most care";
    const double to_middle = half_width(words) + 0.3 * kWords;
    const Point at = on_sheet(middle.at_depth(2.0 * above));
    add_words({at.x + (middle.beta < 0.0 ? -to_middle : to_middle), at.z},
              words);
  }

  [[nodiscard]] Drawing drawing() && { return std::move(out_); }

 private:
  [[nodiscard]] Point on_sheet(Point p) const {
    return {origin_.x + scale_ * p.x, origin_.z + scale_ * p.z};
  }
  static double half_width(const std::string& words) {
    return 0.5 * width_of(letters(words), kWords);
  }
  void add_words(Point at, const std::string& words) {
    out_.shapes.labels.push_back({at, kWords, words, 0.0, true});
  }
  void add_piece(const Piece& piece, std::size_t number) {
    std::vector<Point> corners =
        outline(edge_, piece.from, piece.to, 0.0, edge_.strip());
    for (Point& p : corners) p = on_sheet(p);
    out_.shapes.polylines.push_back({Line::Engrave, std::move(corners), true});
    for (const double along : {piece.holes.front(), piece.holes.back()}) {
      constexpr double kDot = 0.5;
      out_.shapes.circles.push_back(
          {Line::Engrave,
           on_sheet(edge_.at(along).at_depth(0.5 * edge_.strip())), kDot});
    }
    const EdgePoint middle = edge_.at(0.5 * (piece.from + piece.to));
    const Point at =
        on_sheet(middle.at_depth(edge_.strip() + 1.2 * kWords / scale_));
    add_words({at.x, at.z + 0.4 * kWords}, fmt::format("{}", number));
  }
  void add_ends() {
    const Point a = on_sheet({0.0, 0.0});
    const Point b = on_sheet(edge_.at(edge_.length()).place);
    const auto add_line = [&](Point from, Point to) {
      out_.shapes.polylines.push_back({Line::Engrave, {from, to}});
    };
    add_line({room_.low.x, a.z}, {room_.high.x, a.z});
    add_line({a.x, room_.low.z}, {a.x, room_.high.z});
    add_words({a.x - kWords, a.z - 0.5 * kWords}, "A");
    add_words({b.x, b.z - kWords}, "B");
    const std::string level = "level through A", plumb = "plumb through A";
    add_words({room_.high.x - half_width(level), a.z - 0.5 * kWords}, level);
    add_words({a.x + half_width(plumb) + 0.5 * kWords, room_.high.z - 1.0},
              plumb);
  }

  const Edge& edge_;
  Drawing out_;
  Box room_;
  double scale_ = 1.0;
  Point origin_{};
};

}  // namespace

std::string change_in_words(double seconds) {
  if (std::isinf(seconds)) return "stops the body";
  return fmt::format("{:+.3g} ms", 1e3 * seconds);
}

std::vector<Drawing> assembly(const Edge& edge,
                              const std::vector<Piece>& pieces,
                              const std::vector<int>& sheet_of,
                              const std::vector<DisplacedStretch>& stretches,
                              const Build& build, const SheetFrame& frame) {
  AssemblyPicture picture(edge, pieces, frame);
  if (!stretches.empty()) {
    picture.add_dearest(*std::ranges::max_element(
        stretches, {}, [](const DisplacedStretch& stretch) {
          return std::abs(stretch.dearer());
        }));
  }
  std::vector<Drawing> out{std::move(picture).drawing()};
  TableSheets tables(frame, out);
  tables.add(table_of_pieces(edge, pieces, sheet_of));
  tables.add(table_of_errors(stretches, build));
  return out;
}

}  // namespace brachisto::report::cutting
