// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The families of tracks that the paper draws.

#pragma once

#include <string>
#include <vector>

namespace brachisto::reproduction {

/// A case and its name in the key of a figure.
struct Member {
  std::string file;
  std::string name;
};

using Members = std::vector<Member>;

/// Fig. 8, by η_m.
inline const Members kByOffset = {{"fig08_eta_m_0", "η_m = 0"},
                                  {"fig08_eta_m_1_6", "η_m = 1/6"},
                                  {"fig08_eta_m_1_3", "η_m = 1/3"},
                                  {"fig08_eta_m_1_2", "η_m = 1/2"},
                                  {"fig04_reference_case", "η_m = 2/3"},
                                  {"fig08_eta_m_1_sqrt2", "η_m = 1/√2"}};

/// Fig. 9, by θ_m.
inline const Members kByOrientation = {{"fig09_theta_m_m90deg", "θ_m = −90°"},
                                       {"fig09_theta_m_m60deg", "θ_m = −60°"},
                                       {"fig09_theta_m_m30deg", "θ_m = −30°"},
                                       {"fig04_reference_case", "θ_m = 0"},
                                       {"fig09_theta_m_p30deg", "θ_m = 30°"},
                                       {"fig09_theta_m_p60deg", "θ_m = 60°"},
                                       {"fig09_theta_m_p90deg", "θ_m = 90°"}};

/// Fig. 10, by k.
inline const Members kByInertia = {{"fig10_k_0.1", "k = 0.1"},
                                   {"fig10_k_0.3", "k = 0.3"},
                                   {"fig04_reference_case", "k = 0.5"},
                                   {"fig10_k_5_9", "k = 5/9"}};

/// Fig. 11, by r, with the offset 2/3 of its caption.
inline const Members kByRadius = {{"fig11_r_0.2", "r = 0.2"},
                                  {"fig11_r_0.25", "r = 0.25"},
                                  {"fig04_reference_case", "r = 1/3"},
                                  {"fig11_r_0.4", "r = 0.4"},
                                  {"fig11_r_0.5", "r = 0.5"}};

/// Fig. 11, by r, with the offset 1/3 of its text.
inline const Members kByRadiusOfTheText = {
    {"fig11_r_0.2_eta_m_1_3", "r = 0.2"},
    {"fig11_r_0.25_eta_m_1_3", "r = 0.25"},
    {"fig11_r_1_3_eta_m_1_3", "r = 1/3"},
    {"fig11_r_0.4_eta_m_1_3", "r = 0.4"},
    {"fig11_r_0.5_eta_m_1_3", "r = 0.5"}};

/// Fig. 12, by L.
inline const Members kByLength = {{"fig12_L_2", "L = 2"},
                                  {"fig04_reference_case", "L = 3"},
                                  {"fig12_L_4", "L = 4"}};

}  // namespace brachisto::reproduction
