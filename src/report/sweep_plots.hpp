// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scenes of a sweep as curves, maps and scatter plots, and which of them a
/// sweep needs.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/figure.hpp"
#include "report/scale.hpp"
#include "report/sweep_scenes.hpp"

namespace brachisto::report {

/// τ of scenes against a column, which may be of words.
struct XyPlot {
  std::string name;
  std::size_t x_column = 0;
  /// One group of scenes per curve, in the order they are joined.
  std::vector<Scenes> curves;
  /// The column that tells the curves apart.
  std::optional<std::size_t> family;
  bool joined = true;  ///< by lines, where they are resolved
};

/// Curves or dots, ringed where a scene is infeasible; failed scenes are
/// crosses at the bottom. The smallest value of a feasible scene is marked, and
/// that of all, if it is smaller. Dots of a word are spread about it, by a
/// rule, not at random.
///
/// Neighbours are joined where the curve is resolved: at both of them τ lies
/// next to the straight line through the scenes on either side, so that the
/// line between them is out by 2 % of the axis at most.
///
/// \param range  of τ; common to plots that are to be compared
[[nodiscard]] Figure xy_figure(const SweepTable& table, const XyPlot& plot,
                               Extent range);

/// A way across a map: values of its first and its second column.
using MapWay = std::vector<std::pair<double, double>>;

/// Two ordered axes of a sweep: scene (i, j) is scenes[i · n_second + j] and
/// lies where its own values of two numeric columns put it; see in_map_order().
/// Which of them lies to the right their rank says, so that all maps have one
/// orientation.
struct SweepMap {
  std::string name;
  std::size_t first = 0, second = 0;      ///< columns
  std::size_t n_first = 0, n_second = 0;  ///< both at least 2
  Scenes scenes;
  std::vector<MapWay> ways = {};  ///< drawn over the colours
};

/// Colours of τ between the scenes with lines of equal τ, the smallest value of
/// a feasible scene marked, and that of all, if it is smaller. Nothing is drawn
/// across scenes that failed, marked with crosses, or are missing, marked with
/// circles; a line surrounds what is infeasible.
///
/// \param range  of the colours; common to maps that are to be compared
[[nodiscard]] Figure map_figure(const SweepTable& table, const SweepMap& map,
                                Extent range);

/// The same map with two greys for feasible and infeasible scenes.
[[nodiscard]] Figure feasibility_figure(const SweepTable& table,
                                        const SweepMap& map);

/// Dots of the colour of their τ over two numeric columns.
[[nodiscard]] Figure scatter_figure(const SweepTable& table,
                                    const SweepMap& sample, Extent range);

/// "minimum of the grid: τ = 5.09 at η_m = 0.3", of a feasible scene, and of a
/// faster one that is not; rich text.
struct MarkedScene {
  std::size_t scene;
  std::string name;
  bool feasible;
};
[[nodiscard]] std::vector<MarkedScene> marked_scenes(const SweepTable& table,
                                                     const Scenes& scenes);

/// "transit time τ = T / √(H / 2g)", as all these pictures have it.
inline constexpr const char* kTauLabel = "transit time τ = T / √(H / 2g)";

/// Scenes by ascending numbers of a column; as they are if it has words.
[[nodiscard]] Scenes sorted_by(const SweepColumn& column, Scenes scenes);

/// Whether no two of these scenes have the same value.
[[nodiscard]] bool distinct(const SweepColumn& column, const Scenes& scenes);

/// The scenes of a map with both axes in an order in which its cells neither
/// overlap nor vanish; none if sorting the axes, each by the mean of what its
/// column says, does not give one, or if a value is there twice.
[[nodiscard]] std::optional<Scenes> in_map_order(const SweepTable& table,
                                                 const SweepMap& map);

/// A picture and what it shows.
struct SweepDrawing {
  Figure figure;
  std::string caption;  ///< HTML
};

/// Where along the path each limit holds, in shares of the transit time, as
/// bands over the numeric column of a plot: one curve of it. Between scenes
/// with the same arcs in the same order bands are joined. Where an arc is born
/// or dies, they end half-way, at a line; between which values, the caption
/// says.
///
/// Nothing if no limit holds in any of the scenes.
[[nodiscard]] std::optional<SweepDrawing> structure_drawing(
    const SweepTable& table, const XyPlot& plot, std::size_t curve);

/// Drawings of the same scenes.
struct SweepFigure {
  std::string name;  ///< that those of its drawings begin with
  /// Columns that are the same for all its scenes, but not for all of the
  /// sweep.
  std::vector<std::size_t> fixed;
  Scenes scenes;
  Extent tau{0.0, 1.0};  ///< that colours or the vertical axis stand for
  std::vector<SweepDrawing> drawings;
};

/// The figures, and what is to be said of all of them.
struct SweepFigures {
  std::vector<SweepFigure> figures;
  std::vector<std::string> remarks;  ///< sentences of HTML
};

/// Two ordered numeric axes, those that change fastest, make maps; if one has
/// few values, also a family of curves. One makes curves, with an axis of few
/// words as family. A sample that is not ordered, or words alone, make a plot
/// of dots for each column; one of two numbers also has them as coloured dots.
/// Other axes give figures of their own for each combination of their values.
///
/// Lists are drawn in the order of their values. Where that does not make a
/// map, as values are there twice or depend on one another so that cells would
/// overlap, there are only curves, or dots.
///
/// All figures have one range of τ, unless most would show little then. Figures
/// of too many scenes, and too many figures, are left out.
[[nodiscard]] SweepFigures sweep_figures(const SweepTable& table);

}  // namespace brachisto::report
