// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Optimal transit times and path figures computed by methods that share no
// code with this project. H = 1 in all rows, angles in radians, lengths in H.
//
//   ClosedForm  bead and axisymmetric cylinder: the centre runs on a cycloid
//               from (r, 0); one scalar equation solved with 30 digits.
//   Indirect    Pontryagin's conditions in the rolling time, by shooting with
//               an 8th-order Runge–Kutta pair at relative tolerance 1e-13,
//               boundary residuals below 1e-14; 12 digits of τ and 10 of the
//               other figures.

#pragma once

#include <array>
#include <ostream>
#include <string_view>

#include "brachisto/model/scene.hpp"

namespace brachisto::testing {

enum class Source { ClosedForm, Indirect };

struct ReferenceValue {
  const char* name;
  Shape shape;
  double L, r, eta_m, theta_m, k;
  double tau, centre_path_length, rail_length, start_angle, end_angle;
  Source source;

  [[nodiscard]] Scene scene() const {
    Scene scene;
    scene.body = shape == Shape::Bead ? Body::bead()
                                      : Body::cylinder(r, eta_m, theta_m, k);
    scene.L = L;
    scene.H = 1.0;
    return scene;
  }
};

inline std::ostream& operator<<(std::ostream& out, const ReferenceValue& row) {
  return out << row.name;
}

inline constexpr std::array kReferenceValues{
    ReferenceValue{"bead_L2", Shape::Bead, 2.0, 0.0, 0.0, 0.0, 0.0,
                   3.568202221960096, 2.446069842455299, 2.446069842455299,
                   1.570796326794897, -0.1833880574673412, Source::ClosedForm},
    ReferenceValue{"uniform_L2", Shape::Cylinder, 2.0, 0.3333333333333333, 0.0,
                   0.0, 0.5, 3.910416744850416, 1.89541573208797,
                   2.514393270105414, 1.570796326794897, -0.2861362872574364,
                   Source::ClosedForm},
    ReferenceValue{"bead_L3", Shape::Bead, 3.0, 0.0, 0.0, 0.0, 0.0,
                   4.510563136746752, 3.568103861440848, 3.568103861440848,
                   1.570796326794897, -0.4550176852636491, Source::ClosedForm},
    ReferenceValue{"uniform_L3", Shape::Cylinder, 3.0, 0.3333333333333333, 0.0,
                   0.0, 0.5, 5.115100653579787, 2.959968909164491,
                   3.664719129859678, 1.570796326794897, -0.5434543352906646,
                   Source::ClosedForm},
    ReferenceValue{"bead_L4", Shape::Bead, 4.0, 0.0, 0.0, 0.0, 0.0,
                   5.366259555719696, 4.748186434052458, 4.748186434052458,
                   1.570796326794897, -0.6172398797115471, Source::ClosedForm},
    ReferenceValue{"uniform_L4", Shape::Cylinder, 4.0, 0.3333333333333333, 0.0,
                   0.0, 0.5, 6.207240795227849, 4.108685053592888,
                   4.862981716000802, 1.570796326794897, -0.6920936604288455,
                   Source::ClosedForm},
    ReferenceValue{"reference_case", Shape::Cylinder, 3.0, 0.3333333333333333,
                   0.6666666666666666, 0.0, 0.5, 5.093444466618, 3.075522817639,
                   3.635075983287, 1.570796326795, -0.1078631701479,
                   Source::Indirect},
    ReferenceValue{"L2", Shape::Cylinder, 2.0, 0.3333333333333333,
                   0.6666666666666666, 0.0, 0.5, 3.904264219696, 1.753895038452,
                   2.420522188725, 1.570796326795, -0.429085124025,
                   Source::Indirect},
    ReferenceValue{"L4", Shape::Cylinder, 4.0, 0.3333333333333333,
                   0.6666666666666666, 0.0, 0.5, 6.335557087985, 4.81170195888,
                   5.463919055676, 1.570796326795, -0.385854963594,
                   Source::Indirect},
    ReferenceValue{"fast", Shape::Cylinder, 3.0, 0.3333333333333333, 0.8,
                   -0.5235987755982988, 0.1, 4.337613992601, 3.263940123863,
                   3.874517103786, 1.955063432132, 0.123332492362,
                   Source::Indirect},
    ReferenceValue{"theta_-90", Shape::Cylinder, 3.0, 0.3333333333333333,
                   0.6666666666666666, -1.570796326794897, 0.5, 5.250772194035,
                   3.370207295006, 4.070976967269, 1.97888432788,
                   -0.1234246889093, Source::Indirect},
    ReferenceValue{"theta_-60", Shape::Cylinder, 3.0, 0.3333333333333333,
                   0.6666666666666666, -1.047197551196598, 0.5, 5.102226762766,
                   3.244641239512, 3.936455626593, 1.976294674738,
                   -0.09914848650346, Source::Indirect},
    ReferenceValue{"theta_-30", Shape::Cylinder, 3.0, 0.3333333333333333,
                   0.6666666666666666, -0.5235987755982988, 0.5, 5.0370514729,
                   3.142159843837, 3.778306296071, 1.822438793024,
                   -0.08600056367795, Source::Indirect},
    ReferenceValue{"theta_30", Shape::Cylinder, 3.0, 0.3333333333333333,
                   0.6666666666666666, 0.5235987755982988, 0.5, 5.321210088699,
                   3.04629165729, 3.550588007795, 1.319153860566,
                   -0.1937351909507, Source::Indirect},
    ReferenceValue{"theta_60", Shape::Cylinder, 3.0, 0.3333333333333333,
                   0.6666666666666666, 1.047197551196598, 0.5, 5.703055717801,
                   3.038999386717, 3.542042105146, 1.165297978852,
                   -0.3438301764352, Source::Indirect},
    ReferenceValue{"theta_90", Shape::Cylinder, 3.0, 0.3333333333333333,
                   0.6666666666666666, 1.570796326794897, 0.5, 6.101018360078,
                   3.040729791006, 3.609633819468, 1.16270832571,
                   -0.5440037596743, Source::Indirect},
    ReferenceValue{"r_0.2", Shape::Cylinder, 3.0, 0.2, 0.6666666666666666, 0.0,
                   0.5, 5.424799216979, 3.204811428451, 3.549511620721,
                   1.570796326795, -0.1527046345562, Source::Indirect},
    ReferenceValue{"r_0.25", Shape::Cylinder, 3.0, 0.25, 0.6666666666666666,
                   0.0, 0.5, 5.333355055452, 3.623575423877, 4.074620830298,
                   1.570796326795, -0.2333852988922, Source::Indirect},
    ReferenceValue{"r_0.4", Shape::Cylinder, 3.0, 0.4, 0.6666666666666666, 0.0,
                   0.5, 4.993903234316, 3.316614977339, 4.024946168847,
                   1.570796326795, -0.2000316519756, Source::Indirect},
    ReferenceValue{"r_0.5", Shape::Cylinder, 3.0, 0.5, 0.6666666666666666, 0.0,
                   0.5, 4.925534526943, 2.362236254224, 3.493023800639,
                   1.570796326795, -0.6907787660369, Source::Indirect},
    ReferenceValue{"k_0.100", Shape::Cylinder, 3.0, 0.3333333333333333,
                   0.6666666666666666, 0.0, 0.1, 4.281607784166, 3.135794258281,
                   3.654427219212, 1.570796326795, 0.01489744400182,
                   Source::Indirect},
    ReferenceValue{"k_0.300", Shape::Cylinder, 3.0, 0.3333333333333333,
                   0.6666666666666666, 0.0, 0.3, 4.727435447774, 3.099242092197,
                   3.640443736367, 1.570796326795, -0.05280860571373,
                   Source::Indirect},
    ReferenceValue{"k_0.556", Shape::Cylinder, 3.0, 0.3333333333333333,
                   0.6666666666666666, 0.0, 0.5555555555555556, 5.186562834549,
                   3.070268338547, 3.634245538014, 1.570796326795,
                   -0.1211352716055, Source::Indirect},
    ReferenceValue{"eta_0.1667", Shape::Cylinder, 3.0, 0.3333333333333333,
                   0.1666666666666667, 0.0, 0.5, 5.039630529812, 2.970452977464,
                   3.634327503977, 1.570796326795, -0.4208272527443,
                   Source::Indirect},
    ReferenceValue{"eta_0.3333", Shape::Cylinder, 3.0, 0.3333333333333333,
                   0.3333333333333333, 0.0, 0.5, 5.008914536011, 3.00074899199,
                   3.623985795187, 1.570796326795, -0.2989140827965,
                   Source::Indirect},
    ReferenceValue{"eta_0.5000", Shape::Cylinder, 3.0, 0.3333333333333333, 0.5,
                   0.0, 0.5, 5.024302660365, 3.038903820934, 3.625798272894,
                   1.570796326795, -0.1898870290863, Source::Indirect},
    ReferenceValue{"eta_0.7071", Shape::Cylinder, 3.0, 0.3333333333333333,
                   0.7071067811865476, 0.0, 0.5, 5.119746384279, 3.083457334468,
                   3.638018315484, 1.570796326795, -0.09288661625351,
                   Source::Indirect},
};

/// The row of that name; does not compile for a name that is not there.
consteval const ReferenceValue& reference(std::string_view name) {
  for (const ReferenceValue& row : kReferenceValues) {
    if (row.name == name) return row;
  }
  throw "no such reference value";
}

}  // namespace brachisto::testing
