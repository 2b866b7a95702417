// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/path_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/rich_text.hpp"
#include "report/track_kind.hpp"
#include "trajectory/feasibility.hpp"

namespace brachisto::report {

namespace {

// Lengths on the picture [px].
constexpr double kPictureWidth = 860.0, kLeastWidth = 400.0;
constexpr double kPlotHeight = 800.0, kLeastHeight = 150.0;
constexpr double kLeftMargin = 80.0, kRightMargin = 30.0;
constexpr double kTitleHeight = 74.0, kTitleLine = 18.0, kBottomMargin = 120.0;
constexpr double kEnlargedAbove = 34.0, kEnlargedBelow = 74.0;
/// Bodies smaller than this are enlarged to that, and those as small as a dot
/// are drawn as one.
constexpr double kSmallRadius = 8.0, kEnlargedRadius = 45.0, kDot = 3.0;

constexpr int kTimeSteps = 10;

/// Axis-aligned, in metres.
struct Box {
  Point low, high;

  void include(Point p, double radius) {
    low = {std::min(low.x, p.x - radius), std::min(low.z, p.z - radius)};
    high = {std::max(high.x, p.x + radius), std::max(high.z, p.z + radius)};
  }
  /// The same middle, with that width and height.
  [[nodiscard]] Box resized(double width, double height) const {
    const Point middle{0.5 * (low.x + high.x), 0.5 * (low.z + high.z)};
    return {{middle.x - 0.5 * width, middle.z - 0.5 * height},
            {middle.x + 0.5 * width, middle.z + 0.5 * height}};
  }
  [[nodiscard]] double width() const { return high.x - low.x; }
  [[nodiscard]] double height() const { return high.z - low.z; }
};

/// A box with room at the frame, and its size on the picture, of equal scales.
struct Frame {
  Box box;
  double scale;  ///< [px/m]

  Frame(const Box& content, double largest_scale) : box(content) {
    constexpr double kRoom = 1.06;
    const double wide = kRoom * content.width();
    const double high = kRoom * content.height();
    scale = std::min({kPictureWidth / wide, kPlotHeight / high, largest_scale});
    box = content.resized(std::max(wide, kLeastWidth / scale),
                          std::max(high, kLeastHeight / scale));
  }
  [[nodiscard]] double width() const { return scale * box.width(); }
  [[nodiscard]] double height() const { return scale * box.height(); }
};

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.z - b.z);
}

void add_row(std::string& table, std::string_view part,
             const TrajectoryPoint& p) {
  const Kinematics& motion = p.motion;
  fmt::format_to(std::back_inserter(table),
                 "{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},"
                 "{:.9g}\n",
                 part, p.t, motion.contact.x, motion.contact.z, p.centre.x,
                 p.centre.z, motion.mass_centre.x, motion.mass_centre.z,
                 motion.R_n, motion.fold_margin);
}

/// Of rows that nobody could tell apart, the first one.
void add_rows(std::string& table, std::string_view part,
              const std::vector<TrajectoryPoint>& rows, double scale) {
  constexpr double kTooNear = 0.2;  // [px]
  const TrajectoryPoint* last = nullptr;
  for (const TrajectoryPoint& row : rows) {
    const bool too_near =
        last != nullptr && &row != &rows.back() &&
        scale * distance(row.motion.contact, last->motion.contact) < kTooNear &&
        scale * distance(row.motion.mass_centre, last->motion.mass_centre) <
            kTooNear;
    if (too_near) continue;
    add_row(table, part, row);
    last = &row;
  }
}

/// The motion at t = 0, T/n, …, T, to a part of T that no picture shows.
std::vector<TrajectoryPoint> equal_times(
    const Motion& motion, const std::vector<TrajectoryPoint>& rows) {
  std::vector<TrajectoryPoint> out{rows.front()};
  const double step = rows.back().t / kTimeSteps;
  for (int i = 1; i < kTimeSteps; ++i) {
    const auto after =
        std::ranges::lower_bound(rows, i * step, {}, &TrajectoryPoint::t);
    const TrajectoryPoint& before = *std::prev(after);
    const double part = (i * step - before.t) / (after->t - before.t);
    out.push_back(
        motion.at(before.sigma + part * (after->sigma - before.sigma)));
  }
  out.push_back(rows.back());
  return out;
}

/// The piece of the track about its lowest place that is shown enlarged.
struct Enlarged {
  std::vector<TrajectoryPoint> rows;
  TrajectoryPoint body;
  Frame frame;
};

std::optional<Enlarged> enlarged(const Motion& motion,
                                 const std::vector<TrajectoryPoint>& rows,
                                 double scale) {
  const Body& body = motion.scene().body;
  if (!body.off_centred() || body.radius * scale >= kSmallRadius) return {};
  const double half = 0.5 * kPictureWidth * body.radius / kEnlargedRadius;
  const auto lowest = std::ranges::max_element(
      rows, {}, [](const TrajectoryPoint& p) { return p.centre.z; });
  const double middle =
      std::clamp(lowest->s, half, std::max(half, rows.back().s - half));
  const TrajectoryPoint& at =
      *std::ranges::lower_bound(rows, middle, {}, &TrajectoryPoint::s);
  // A little more than the frame shows.
  constexpr double kMore = 1.3;
  Box box{at.centre, at.centre};
  box.include(at.centre, body.radius);
  std::vector<TrajectoryPoint> piece;
  for (const TrajectoryPoint& p : rows) {
    if (std::abs(p.s - middle) > kMore * half) continue;
    piece.push_back(p);
    if (std::abs(p.centre.x - at.centre.x) > half) continue;
    box.include(p.motion.contact, 0.0);
    box.include(p.centre, 0.0);
    box.include(p.motion.mass_centre, 0.0);
  }
  Frame frame(box, kEnlargedRadius / body.radius);
  frame.box =
      frame.box.resized(kPictureWidth / frame.scale, frame.box.height());
  return Enlarged{std::move(piece), at, frame};
}

/// The picture being put together.
class Picture {
 public:
  Picture(const Motion& motion, const PathDiagnostics& diagnostics)
      : motion_(motion),
        body_(motion.scene().body),
        reasons_(infeasible_because(motion.scene(), diagnostics)),
        lifts_off_(diagnostics.min_normal_force.value < 0.0),
        folds_(diagnostics.min_fold_margin.value < 0.0),
        rows_(motion.fine_sample(600)),
        frame_(content(), std::numeric_limits<double>::infinity()),
        enlarged_(enlarged(motion, rows_, frame_.scale)) {}

  [[nodiscard]] Figure figure() {
    Figure figure;
    figure.name = "path";
    width_ = kLeftMargin + kPictureWidth + kRightMargin;
    const double above =
        kTitleHeight + kTitleLine * static_cast<double>(reasons_.size());
    constexpr double kKey = 66.0;  // below the plot
    const double bottom = above + frame_.height() + kBottomMargin;
    height_ = bottom;
    if (enlarged_) {
      height_ += kEnlargedAbove + enlarged_->frame.height() + kEnlargedBelow;
    }
    table_ = "part,t,x_b,z_b,x_c,z_c,x_cm,z_cm,R_n,fold_margin\n";
    add_rows(table_, "track", rows_, frame_.scale);
    for (const TrajectoryPoint& p : equal_times(motion_, rows_)) {
      add_row(table_, "step", p);
    }
    style();
    title();
    put("set key at screen {:.5f}, screen {:.5f}\n",
        (kLeftMargin + 0.5 * kPictureWidth) / width_,
        1.0 - (above + frame_.height() + kKey) / height_);
    ends();
    if (enlarged_) window();
    place(frame_, above);
    draw("track", "step", true);
    if (enlarged_) {
      add_rows(table_, "piece", enlarged_->rows, enlarged_->frame.scale);
      add_row(table_, "body", enlarged_->body);
      put("unset label\nunset object 1\nunset key\n");
      put("set title 'the piece in the small frame, {:.0f} times as large'\n",
          enlarged_->frame.scale / frame_.scale);
      place(enlarged_->frame, bottom + kEnlargedAbove);
      draw("piece", "body", false);
      put("unset multiplot\n");
    }
    figure.table = std::move(table_);
    figure.commands = std::move(commands_);
    figure.width = width_;
    figure.height = height_;
    figure.title = std::move(title_);
    return figure;
  }

 private:
  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(commands_), format,
                   std::forward<Args>(args)...);
  }

  [[nodiscard]] Box content() const {
    Box box{rows_.front().centre, rows_.front().centre};
    for (const TrajectoryPoint& row : rows_) {
      box.include(row.motion.contact, 0.0);
      box.include(row.centre, body_.radius);
    }
    return box;
  }

  void style() {
    put("set border 15 lw 1 lc rgb '#333333'\n"
        "set grid lt 1 lw 1 lc rgb '#e3e3e3'\n"
        "set tics out nomirror format '%g'\n"
        "set xlabel 'x [m]' offset 0,0.2\n"
        "set ylabel 'z [m], down'\n"
        "set key center top vertical Left reverse samplen 3 maxrows 2\n");
  }

  void title() {
    std::string kind(track_kind(motion_.scene()));
    kind[0] = static_cast<char>(std::toupper(kind[0]));
    const std::string head = fmt::format("{}: τ = {:.8f}, T = {:.6g} s", kind,
                                         motion_.tau(), motion_.transit_time());
    title_ = plain_words(head + ", " + in_words(motion_.scene()));
    const auto line = [&](int index, double y, std::string_view style,
                          const std::string& text) {
      put("set label {} '{}' at screen {:.5f}, screen {:.5f} {}\n", index,
          gnuplot_words(text), kLeftMargin / width_, 1.0 - y / height_, style);
    };
    line(1, 22.0, "font ',16'", head);
    line(2, 46.0, "textcolor rgb '#444444'", in_words(motion_.scene()));
    double y = 46.0;
    int index = 3;
    for (const std::string& reason : reasons_) {
      y += kTitleLine;
      line(index++, y, "textcolor rgb '#b00000'", "Infeasible: " + reason);
    }
  }

  /// Where the enlarged piece is.
  void window() {
    constexpr double kLeastSize = 14.0;  // [px]
    const Box& box = enlarged_->frame.box;
    const Box seen =
        box.resized(std::max(box.width(), kLeastSize / frame_.scale),
                    std::max(box.height(), kLeastSize / frame_.scale));
    put("set object 1 rectangle from {:.9g},{:.9g} to {:.9g},{:.9g} "
        "front fs empty border lc rgb '#333333'\nset multiplot\n",
        seen.low.x, seen.low.z, seen.high.x, seen.high.z);
  }

  /// The frame, its upper edge at `top` [px].
  void place(const Frame& frame, double top) {
    const double left = kLeftMargin + 0.5 * (kPictureWidth - frame.width());
    put("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n",
        left / width_, (left + frame.width()) / width_);
    put("set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
        1.0 - top / height_, 1.0 - (top + frame.height()) / height_);
    put("set xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\n",
        frame.box.low.x, frame.box.high.x, frame.box.high.z, frame.box.low.z);
  }

  /// Curves of the rows of one part, bodies of those of another one.
  void draw(std::string_view curves, std::string_view bodies, bool marks) {
    std::string_view before = "plot ";
    const auto item = [&](std::string_view rows, std::string_view at,
                          std::string_view style, std::string_view name) {
      put("{}data using (part('{}', 'x_{}')):(column('z_{}')){} title '{}'",
          before, rows, at, at, style, name);
      before = ", \\\n  ";
    };
    const bool dots = marks && body_.radius * frame_.scale < kDot;
    const std::string times = fmt::format("every T/{}", kTimeSteps);
    if (!dots) {
      item(bodies, "c",
           fmt::format(":({:.9g}) with circles fc rgb '#bbbbbb' fs transparent "
                       "solid 0.25 border lc rgb '#777777'",
                       body_.radius),
           "body, " + times);
    }
    if (body_.rolls()) {
      item(curves, "c", " with lines lw 1.4 dt (5,3) lc rgb '#777777'",
           "its centre");
    }
    if (body_.off_centred()) {
      item(curves, "cm", " with lines lw 1.6 dt (1.2,2.2) lc rgb '#1f5fa8'",
           "its centre of mass");
    }
    item(curves, "b", " with lines lw 2.6 lc rgb '#000000'", "track");
    if (dots) {
      item(bodies, "c", " with points pt 7 ps 1.1 lc rgb '#ffffff'", "");
      item(bodies, "c", " with points pt 6 ps 1.1 lc rgb '#000000'",
           "body, " + times);
    } else if (body_.off_centred()) {
      item(bodies, "c",
           ":(column('x_cm') - column('x_c')):(column('z_cm') - column('z_c')) "
           "with vectors nohead lc rgb '#1f5fa8'",
           "");
      item(bodies, "cm", " with points pt 7 ps 0.8 lc rgb '#1f5fa8'", "");
    }
    impossible(curves);
    put("\n");
  }

  /// Where the track could not be run on.
  void impossible(std::string_view curves) {
    if (!body_.rolls()) return;
    const auto where = [&](std::string_view column, std::string_view style) {
      put(", \\\n  data using (part('{}', 't') > 0 && column('{}') < 0 ? "
          "column('x_b') : NaN):(column('z_b')) with {}",
          curves, column, style);
    };
    if (lifts_off_) {
      where("R_n",
            "lines lw 6 lc rgb '#80d00000' title 'R_{n} < 0: lifts off'");
    }
    if (folds_) {
      where("fold_margin",
            "points pt 2 ps 0.8 lw 1.5 lc rgb '#b00000' title 'folds'");
    }
  }

  /// A and B, the letters outside of the body.
  void ends() {
    const auto letter = [&](int index, std::string_view name, Point at,
                            std::string_view place) {
      put("set label {} '{{/:Italic {}}}' at {:.9g},{:.9g} {} point pt 7 "
          "ps 0.7 lc rgb '#000000' front\n",
          index, name, at.x, at.z, place);
    };
    letter(8, "A", rows_.front().motion.contact, "right offset -0.7,-0.6");
    letter(9, "B", rows_.back().motion.contact, "left offset 0.7,-0.7");
  }

  const Motion& motion_;
  const Body& body_;
  std::vector<std::string> reasons_;
  bool lifts_off_, folds_;
  std::vector<TrajectoryPoint> rows_;
  Frame frame_;
  std::optional<Enlarged> enlarged_;
  double width_ = 0.0, height_ = 0.0;
  std::string table_, commands_, title_;
};

}  // namespace

Figure path_figure(const Motion& motion, const PathDiagnostics& diagnostics) {
  return Picture(motion, diagnostics).figure();
}

}  // namespace brachisto::report
