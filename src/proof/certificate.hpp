// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A proof as a file that another run can check.

#pragma once

#include <string>

#include "proof/scene_json.hpp"
#include "proof/theorems.hpp"

namespace brachisto::proof {

/// Of the file, and of the formulas that it speaks of: it grows when what the
/// unknowns or the theorems mean changes.
inline constexpr int kCertificateVersion = 3;

/// Proves what can be proven of a scene, whose numbers of 64 bits are exact.
/// \throws NotProven  if not even that the extremal exists
[[nodiscard]] Json prove(const Scene& scene, const Accuracy& accuracy);

/// Of a certificate without its digest: tells what was changed by accident or
/// by an editor. What a check believes does not rest on it.
[[nodiscard]] std::string digest(Json certificate);

/// The scene of a certificate.
/// \throws Refused  if it is of another version, or its digest is not its own
[[nodiscard]] Scene scene_of(const Json& certificate);

/// Whether a scene is that of a certificate, to the last bit of what matters:
/// body, ends and contact.
[[nodiscard]] bool is_of(const Json& certificate, const Scene& scene);

/// Shows again what a certificate says, with more bits, more terms and shorter
/// steps.
/// \return what was shown, in the form of a certificate
/// \throws Refused    if it says more than is shown
/// \throws NotProven  if the root is not found again
[[nodiscard]] Json check(const Json& certificate);

/// How far τ of a computation is from the enclosure's, at most.
[[nodiscard]] double distance_to_tau(const Json& certificate, double tau);

/// For people.
[[nodiscard]] std::string in_words(const Json& certificate);

/// The theorem with what it assumes, what was done and what is trusted, in
/// Markdown.
[[nodiscard]] std::string page(const Json& certificate);

/// Bits that may be asked for.
inline constexpr int kLeastBits = 96, kMostBits = 1024;

/// The bits of Accuracy with terms to match.
[[nodiscard]] Accuracy accuracy_of(int bits);

}  // namespace brachisto::proof
