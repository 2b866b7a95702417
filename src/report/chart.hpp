// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A figure of curves: what it shows.

#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/canvas.hpp"

namespace brachisto::report {

/// A place in a figure, in the units of its axes.
struct Datum {
  double x = 0.0, y = 0.0;
};

/// Lines that differ in grey too.
enum class Stroke { Solid, Dashed, Dotted, DashDotted };

/// Marks that differ in black and white.
enum class Mark { None, Disc, Circle, Square, Triangle, Diamond, Cross };

/// One line of a chart. Where a coordinate is not finite it is interrupted.
struct Curve {
  std::string name = {};  ///< rich text for the key; empty: not in the key
  std::vector<Datum> points = {};
  Stroke stroke = Stroke::Solid;
  std::string colour = "#000000";
  double width = 1.8;  ///< [px]; 0: marks alone
  Mark mark = Mark::None;
  double mark_size = 0.8;
  /// Column of the CSV file by which the curve is told from others; `name`
  /// without markup if empty.
  std::string id = {};
};

/// A filled polygon behind the curves.
struct Area {
  std::string name = {};  ///< rich text for the key; empty: not in the key
  std::vector<Datum> outline;
  std::string fill = "#e8e8e8";
};

/// A circle of the given radius in the units of axes of equal scale: a body.
struct Round {
  Datum centre;
  double radius = 0.0;
  std::optional<Datum> mass_centre;  ///< drawn as a dot
};

/// A small picture of a body whose size does not follow the axes.
struct Sketch {
  Datum at;
  double radius = 20.0;  ///< [px]
  /// Point masses, in units of the radius, y down.
  std::vector<Datum> masses;
  std::vector<double> rings;  ///< radii of rings, in units of the radius
  std::string name;           ///< rich text beside it
};

/// A place with a name, a mark and words beside it.
struct Note {
  Datum at;
  std::string text;  ///< rich text
  Mark mark = Mark::Disc;
  double dx = 8.0, dy = -8.0;  ///< of the words from the mark [px]; a negative
                               ///< dx ends them there
};

/// How the n-th line of a family is told from others in grey.
[[nodiscard]] Stroke stroke_of(std::size_t n);

/// Words are rich text: an underscore or a caret lowers or raises the letter,
/// or the group in braces, that follows.
struct Chart {
  std::string name;      ///< of its files, without ending
  std::string title;     ///< above the plot
  std::string subtitle;  ///< below the title, smaller; in lines if it is long
  Side x, y;
  bool equal_scale = false;  ///< one unit has one length in both directions
  bool y_down = false;       ///< y grows downwards, as z does
  std::vector<Area> areas;
  std::vector<Curve> curves;
  std::vector<Round> rounds;
  std::vector<Sketch> sketches;
  std::vector<Note> notes;
  bool notes_apart = false;  ///< words of notes move off each other and marks
  /// Scenes of a sweep and where they are, curve by curve.
  std::vector<std::pair<std::size_t, Datum>> scenes = {};
  std::size_t scenes_per_curve = 0;  ///< if all have so many
};

/// The chart as table (`part,x,y`, one row per point, 12 significant digits)
/// and script: 720 px wide, with the key below the plot in columns if there is
/// more than one name. On axes of equal scale the height follows the data
/// within limits; a range is widened rather than a scale changed.
[[nodiscard]] Figure chart_figure(const Chart& chart);

}  // namespace brachisto::report
