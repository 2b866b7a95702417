// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Answers and races as HTML: pages, and what notebooks show.

#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/study/design.hpp"
#include "brachisto/study/solution.hpp"
#include "plot/race_page.hpp"

namespace brachisto::python {

/// A solution, and the design that chose its body, if one did.
struct Answered {
  Solution solution;
  std::optional<DesignAnswer> design = {};

  [[nodiscard]] std::string json() const;
  [[nodiscard]] std::string summary() const;
};

/// The page of an answer. \pre it is verified
/// \param interrupt  nonzero: stop
/// \throws Stopped
[[nodiscard]] std::string page_of(const Answered& answered,
                                  const std::atomic<int>& interrupt);
/// What a notebook shows of it.
[[nodiscard]] std::string card_of(const Answered& answered);

/// Bodies in the order of their arrival.
class Race {
 public:
  /// \throws io::InputError  if the tracks do not have the same ends
  /// \pre all are verified, and of each there is a name
  Race(const std::vector<std::string>& names,
       const std::vector<const Answered*>& answers, bool same_track);

  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] std::vector<std::string> behind() const;
  [[nodiscard]] std::string page(const std::atomic<int>& interrupt) const;
  [[nodiscard]] std::string card() const;

 private:
  std::vector<plot::Racer> racers_;    ///< as they start
  std::vector<plot::Racer> arrivals_;  ///< as they arrive
  bool same_track_;
};

/// Writes one file, in full or not at all.
/// \throws report::OutputError
void write_page(const std::string& path, const std::string& page, bool force);

/// What write_page() would refuse, as far as it can be known beforehand.
/// \throws report::OutputError
void check_page(const std::string& path, bool force);

}  // namespace brachisto::python
