// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/path_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/canvas.hpp"
#include "report/path_frame.hpp"
#include "report/rich_text.hpp"
#include "report/track_kind.hpp"
#include "trajectory/feasibility.hpp"

namespace brachisto::report {

namespace {

// Lengths on the picture [px].
constexpr double kLeftMargin = 80.0, kRightMargin = 30.0;
constexpr double kTitleHeight = 74.0, kTitleLine = 18.0, kBottomMargin = 120.0;
constexpr double kEnlargedAbove = 34.0, kEnlargedBelow = 74.0;
/// Bodies as small as a dot are drawn as one.
constexpr double kDot = 3.0;

constexpr int kTimeSteps = 10;

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

/// Of the band beneath an active arc: colours that differ for all kinds of
/// sight, widths and dashes that differ in grey.
struct Band {
  std::string_view colour;
  double width;  ///< [px]
  std::string_view dash;
};
constexpr std::array kBands{Band{"#e69f00", 10.0, "solid"},
                            Band{"#0072b2", 7.0, "solid"},
                            Band{"#cc79a7", 13.0, "(0.8,0.4)"},
                            Band{"#009e73", 8.0, "(0.4,0.4)"},
                            Band{"#56b4e9", 14.0, "solid"},
                            Band{"#d55e00", 6.0, "(1.2,0.4,0.4,0.4)"}};

/// Names of keys have underscores that lower nothing.
std::string keys_as_they_are(const std::string& reason) {
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto letters = [&](std::size_t first) {
    return first + 1 < reason.size() && is_letter(reason[first]) &&
           is_letter(reason[first + 1]);
  };
  std::string out;
  for (std::size_t i = 0; i < reason.size(); ++i) {
    if (reason[i] == '_' && i >= 2 && letters(i - 2) && letters(i + 1)) {
      out += '\\';
    }
    out += reason[i];
  }
  return out;
}

/// The picture being put together.
class PathPicture {
 public:
  explicit PathPicture(const Solution& solution)
      : solution_(solution),
        motion_(*solution.motion()),
        scene_(solution.scene),
        body_(scene_.body),
        reasons_(solution.infeasible_because()),
        lifts_off_(solution.diagnostics->min_normal_force.value <
                       -solution.diagnostics->normal_force_error &&
                   !forbid_lift_off(scene_.limits)),
        folds_(folds(scene_, *solution.diagnostics)),
        rows_(motion_.fine_sample(600)),
        frame_(content(), std::numeric_limits<double>::infinity()),
        enlarged_(enlarged(motion_, rows_, frame_.scale)) {}

  [[nodiscard]] Figure figure() {
    canvas_.width = kLeftMargin + kPictureWidth + kRightMargin;
    const std::size_t more_lines =
        reasons_.size() + (scene_.limits.any() ? 1 : 0);
    const double above =
        kTitleHeight + kTitleLine * static_cast<double>(more_lines);
    constexpr double kKey = 66.0, kKeyLine = 18.0;  // below the plot
    const double bottom = above + frame_.height() + kBottomMargin +
                          kKeyLine * static_cast<double>(key_rows() - 2);
    canvas_.height = bottom;
    if (enlarged_) {
      canvas_.height +=
          kEnlargedAbove + enlarged_->frame.height() + kEnlargedBelow;
    }
    table_ = "part,t,x_b,z_b,x_c,z_c,x_cm,z_cm,R_n,fold_margin\n";
    add_rows(table_, "track", rows_, frame_.scale);
    for (const TrajectoryPoint& p : equal_times(motion_, rows_)) {
      add_row(table_, "step", p);
    }
    add_arcs();
    style();
    title();
    canvas_.put("set key at screen {:.5f}, screen {:.5f}\n",
                (kLeftMargin + 0.5 * kPictureWidth) / canvas_.width,
                1.0 - (above + frame_.height() + kKey) / canvas_.height);
    ends();
    if (enlarged_) window();
    place(frame_, above);
    draw(frame_, "track", "step", true);
    if (enlarged_) {
      add_rows(table_, "piece", enlarged_->rows, enlarged_->frame.scale);
      add_row(table_, "body", enlarged_->body);
      canvas_.put("unset label\nunset object 1\nunset key\n");
      canvas_.put(
          "set title 'the piece in the small frame, {:.0f} times as large'\n",
          enlarged_->frame.scale / frame_.scale);
      place(enlarged_->frame, bottom + kEnlargedAbove);
      draw(enlarged_->frame, "piece", "body", false);
      canvas_.put("unset multiplot\n");
    }
    Figure figure = std::move(canvas_).figure("path", std::move(table_));
    figure.title = std::move(title_);
    return figure;
  }

 private:
  [[nodiscard]] Box content() const {
    Box box{rows_.front().centre, rows_.front().centre};
    for (const TrajectoryPoint& row : rows_) {
      box.include(row.motion.contact, 0.0);
      box.include(row.centre, body_.outer_radius());
    }
    // Of what is in the way so much that one sees it.
    const double more = 0.16 * std::max(box.width(), box.height());
    const Box reach = box.resized(box.width() + more, box.height() + more);
    for (const Outline& area :
         obstacles(scene_.limits, reach.low, reach.high)) {
      for (const Point corner : area) box.include(corner, 0.0);
    }
    return box;
  }

  /// Limits that hold somewhere as equations.
  [[nodiscard]] std::vector<const LimitOnPath*> active() const {
    std::vector<const LimitOnPath*> out;
    for (const LimitOnPath& limit : solution_.limits) {
      if (!limit.active.empty()) out.push_back(&limit);
    }
    return out;
  }

  static std::string arc_name(const LimitOnPath& limit, std::size_t arc) {
    return fmt::format("{} {}", limit.name, arc + 1);
  }

  /// The track along the arcs on which a limit holds.
  void add_arcs() {
    const double scale = enlarged_ ? enlarged_->frame.scale : frame_.scale;
    for (const LimitOnPath* limit : active()) {
      for (std::size_t i = 0; i < limit->active.size(); ++i) {
        const Interval& sigma = limit->active[i].sigma;
        std::vector<TrajectoryPoint> arc{motion_.at(sigma.from)};
        for (const TrajectoryPoint& row : rows_) {
          if (sigma.from < row.sigma && row.sigma < sigma.to) {
            arc.push_back(row);
          }
        }
        arc.push_back(motion_.at(sigma.to));
        add_rows(table_, arc_name(*limit, i), arc, scale);
      }
    }
  }

  /// What is forbidden within a frame; the parts of the table that tell it.
  std::vector<std::string> add_obstacles(const Frame& frame,
                                         std::string_view rows) {
    std::vector<std::string> parts;
    for (const Outline& area :
         obstacles(scene_.limits, frame.box.low, frame.box.high)) {
      parts.push_back(fmt::format("obstacle {} of {}", parts.size() + 1, rows));
      const auto add = [&](Point corner) {
        fmt::format_to(std::back_inserter(table_), "{},,{:.9g},{:.9g},,,,,,\n",
                       parts.back(), corner.x, corner.z);
      };
      std::ranges::for_each(area, add);
      add(area.front());
    }
    return parts;
  }

  void style() {
    canvas_.put(
        "set border 15 lw 1 lc rgb '#333333'\n"
        "set grid lt 1 lw 1 lc rgb '#e3e3e3'\n"
        "set tics out nomirror format '%g'\n"
        "set xlabel 'x [m]' offset 0,0.2\n"
        "set ylabel 'z [m], down'\n"
        "set key center top vertical Left reverse samplen 3 maxrows {}\n",
        key_rows());
  }

  /// The path alone needs two; beside the names of limits there is room for
  /// three columns.
  [[nodiscard]] std::size_t key_rows() const {
    constexpr std::size_t kPath = 6, kColumns = 3, kLeast = 2;
    const std::size_t entries = kPath + active().size() + 1;
    return active().empty() ? kLeast : (entries + kColumns - 1) / kColumns;
  }

  void title() {
    std::string kind(track_kind(scene_));
    kind[0] = static_cast<char>(std::toupper(kind[0]));
    const std::string head = fmt::format("{}: τ = {:.8f}, T = {:.6g} s", kind,
                                         motion_.tau(), motion_.transit_time());
    title_ = plain_words(head + ", " + in_words(scene_));
    const auto line = [&](double y, std::string_view style,
                          const std::string& text) {
      canvas_.words(text, kLeftMargin, y, style);
    };
    line(22.0, "font ',16'", head);
    double y = 46.0;
    line(y, "textcolor rgb '#444444'", in_words(scene_));
    if (scene_.limits.any()) {
      y += kTitleLine;
      const std::string limits = "Limits: " + limits_in_words(scene_);
      title_ += ". " + plain_words(limits);
      line(y, "textcolor rgb '#444444'", limits);
    }
    for (const std::string& reason : reasons_) {
      y += kTitleLine;
      line(y, "textcolor rgb '#b00000'",
           "Infeasible: " + keys_as_they_are(reason));
    }
  }

  /// Where the enlarged piece is.
  void window() {
    constexpr double kLeastSize = 14.0;  // [px]
    const Box& box = enlarged_->frame.box;
    const Box seen =
        box.resized(std::max(box.width(), kLeastSize / frame_.scale),
                    std::max(box.height(), kLeastSize / frame_.scale));
    canvas_.put(
        "set object 1 rectangle from {:.9g},{:.9g} to {:.9g},{:.9g} "
        "front fs empty border lc rgb '#333333'\nset multiplot\n",
        seen.low.x, seen.low.z, seen.high.x, seen.high.z);
  }

  /// The frame, its upper edge at `top` [px].
  void place(const Frame& frame, double top) {
    const double left = kLeftMargin + 0.5 * (kPictureWidth - frame.width());
    canvas_.frame(left, top, frame.width(), frame.height());
    canvas_.put("set xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\n",
                frame.box.low.x, frame.box.high.x, frame.box.high.z,
                frame.box.low.z);
  }

  /// Curves of the rows of one part, bodies of those of another one.
  void draw(const Frame& frame, std::string_view curves,
            std::string_view bodies, bool marks) {
    const auto item = [&](std::string_view rows, std::string_view at,
                          std::string_view style, const std::string& name) {
      canvas_.layer(
          fmt::format("data using (part('{}', 'x_{}')):(column('z_{}')){}",
                      rows, at, at, style),
          name);
    };
    const char* forbidden = "out of bounds";
    for (const std::string& area : add_obstacles(frame, curves)) {
      item(
          area, "b",
          " with filledcurves closed fc rgb '#a08050' fs transparent pattern 4 "
          "border lc rgb '#604820' lw 1.5",
          forbidden);
      forbidden = "";
    }
    const bool dots = marks && body_.outer_radius() * frame_.scale < kDot;
    const std::string times = fmt::format("every T/{}", kTimeSteps);
    if (!dots) {
      item(bodies, "c",
           fmt::format(":({:.9g}) with circles fc rgb '#bbbbbb' fs transparent "
                       "solid 0.25 border lc rgb '#777777'",
                       body_.outer_radius()),
           "body, " + times);
    }
    bands(item);
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
    canvas_.plot();
  }

  /// Beneath the track, where limits hold.
  template <class Item>
  void bands(const Item& item) {
    const Band* band = kBands.begin();
    for (const LimitOnPath* limit : active()) {
      std::string name = as_rich_text(limit->name) + " active";
      for (std::size_t i = 0; i < limit->active.size(); ++i) {
        item(arc_name(*limit, i), "b",
             fmt::format(" with lines lw {} dt {} lc rgb '{}'", band->width,
                         band->dash, band->colour),
             name);
        name.clear();
      }
      if (++band == kBands.end()) band = kBands.begin();
    }
  }

  /// Where the track could not be run on.
  void impossible(std::string_view curves) {
    if (!body_.rolls()) return;
    const auto where = [&](std::string_view column, std::string_view style,
                           const char* name) {
      canvas_.layer(
          fmt::format("data using (part('{}', 't') > 0 && column('{}') < 0 ? "
                      "column('x_b') : NaN):(column('z_b')) with {}",
                      curves, column, style),
          name);
    };
    if (lifts_off_) {
      where("R_n", "lines lw 6 lc rgb '#80d00000'", "R_n < 0: lifts off");
    }
    if (folds_) {
      where("fold_margin", "points pt 2 ps 0.8 lw 1.5 lc rgb '#b00000'",
            "folds");
    }
  }

  /// A and B, the letters outside of the body.
  void ends() {
    const auto letter = [&](std::string_view name, Point at,
                            std::string_view place) {
      canvas_.put(
          "set label '{{/:Italic {}}}' at {:.9g},{:.9g} {} point pt 7 "
          "ps 0.7 lc rgb '#000000' front\n",
          name, at.x, at.z, place);
    };
    letter("A", rows_.front().motion.contact, "right offset -0.7,-0.6");
    letter("B", rows_.back().motion.contact, "left offset 0.7,-0.7");
  }

  const Solution& solution_;
  const Motion& motion_;
  const Scene& scene_;
  const Body& body_;
  std::vector<std::string> reasons_;
  bool lifts_off_, folds_;
  std::vector<TrajectoryPoint> rows_;
  Frame frame_;
  std::optional<Enlarged> enlarged_;
  Canvas canvas_;
  std::string table_, title_;
};

}  // namespace

Figure path_figure(const Solution& solution) {
  return PathPicture(solution).figure();
}

}  // namespace brachisto::report
