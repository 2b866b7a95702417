// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "python/views.hpp"

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/math/clock.hpp"
#include "brachisto/report/result.hpp"
#include "plot/answer_card.hpp"
#include "plot/answer_page.hpp"
#include "plot/racers.hpp"
#include "plot/trajectory_table.hpp"

namespace brachisto::python {

namespace {

/// The directory and the name of a file.
std::pair<std::filesystem::path, std::string> place_of(
    const std::string& file) {
  const std::filesystem::path path = file;
  return {path.has_parent_path() ? path.parent_path() : ".",
          path.filename().string()};
}

plot::TrajectoryTable table_of(const Answered& answered) {
  return plot::TrajectoryTable::read(report::trajectory_csv(answered.solution));
}

}  // namespace

std::string Answered::json() const {
  return report::result_json(solution, design ? &*design : nullptr);
}

std::string Answered::summary() const {
  return report::summary(solution, design ? &*design : nullptr);
}

std::string page_of(const Answered& answered,
                    const std::atomic<int>& interrupt) {
  const StopScope scope{StopCondition(&interrupt)};
  return plot::answer_page(report::Json::parse(answered.json()),
                           answered.solution.scene, table_of(answered));
}

std::string card_of(const Answered& answered) {
  const report::Json result = report::Json::parse(answered.json());
  if (!answered.solution.verified()) return plot::failure_card(result);
  return plot::answer_card(result, answered.solution.scene, table_of(answered));
}

Race::Race(const std::vector<std::string>& names,
           const std::vector<const Answered*>& answers, bool same_track)
    : same_track_(same_track) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    racers_.push_back(plot::racer_of(names[i], answers[i]->solution));
    try {
      plot::check_ends(names[i], racers_.front(), racers_.back());
    } catch (const io::InputError& error) {
      // No file tells whose fault it is.
      std::vector<io::Diagnostic> diagnostics = error.diagnostics();
      for (io::Diagnostic& found : diagnostics) {
        found.message = "\"" + names[i] + "\": " + found.message;
      }
      throw io::InputError(std::move(diagnostics));
    }
  }
  arrivals_ = plot::in_order_of_arrival(racers_);
}

std::vector<std::string> Race::names() const {
  std::vector<std::string> out;
  for (const plot::Racer& racer : arrivals_) out.push_back(racer.name);
  return out;
}

std::vector<std::string> Race::behind() const {
  std::vector<std::string> out;
  for (const plot::Racer& racer : arrivals_) {
    out.push_back(plot::behind(arrivals_.front(), racer));
  }
  return out;
}

std::string Race::page(const std::atomic<int>& interrupt) const {
  const StopScope scope{StopCondition(&interrupt)};
  return plot::race_page(racers_, same_track_);
}

std::string Race::card() const {
  return plot::race_card(arrivals_);
}

void write_page(const std::string& path, const std::string& page, bool force) {
  const auto [directory, name] = place_of(path);
  report::write_files(directory, {{name, page}}, force);
}

void check_page(const std::string& path, bool force) {
  const auto [directory, name] = place_of(path);
  report::check_writable(directory, {name}, force);
}

}  // namespace brachisto::python
