// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/merge.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

namespace brachisto::sweep {

namespace {

/// A result without what differs from run to run.
nlohmann::json essence(const std::string& document) {
  nlohmann::json json = nlohmann::json::parse(document);
  json.erase("seconds");
  return json;
}

Store open_part(const std::filesystem::path& part, const StoreInfo& target) {
  Store store = Store::open(part, Database::Access::ReadOnly);
  const std::string name = (part / Store::kFileName).string();
  if (store.info().input_hash != target.input_hash) {
    throw StoreError(name + ": of another sweep: " +
                     difference(job_from_line(store.info().job).file,
                                job_from_line(target.job).file));
  }
  if (store.info().version != target.version) {
    throw StoreError(name + ": made by brachisto " + store.info().version +
                     ", the first part by " + target.version);
  }
  return store;
}

}  // namespace

MergeReport merge(const std::vector<std::filesystem::path>& parts,
                  Store& target, const Job& job) {
  const ChainPlan plan(job.file);
  std::vector<Store> stores;
  stores.reserve(parts.size());
  for (const auto& part : parts) {
    stores.push_back(open_part(part, target.info()));
  }

  MergeReport report;
  std::map<std::size_t, std::string> known;
  target.for_each_result([&](std::size_t scene, const std::string& document) {
    known.emplace(scene, document);
  });
  std::vector<Answer> added;
  for (Store& store : stores) {
    store.for_each_result([&](std::size_t scene, const std::string& document) {
      const auto [place, is_new] = known.emplace(scene, document);
      if (is_new) {
        added.push_back({scene, document, ""});
      } else if (essence(place->second) == essence(document)) {
        report.overlaps.push_back(scene);
      } else {
        report.conflicts.push_back(scene);
      }
    });
    // The last scene of a chain that is not finished brings its state along.
    for (Answer& answer : added) {
      const Chain chain = plan.of_scene(answer.scene);
      const bool last_known =
          answer.scene + 1 < chain.last && !known.contains(answer.scene + 1);
      if (last_known && answer.state.empty()) {
        answer.state = store.state_of(chain.id);
      }
    }
  }
  std::sort(added.begin(), added.end(),
            [](const Answer& a, const Answer& b) { return a.scene < b.scene; });
  target.record(added, plan);

  report.added = added.size();
  std::sort(report.overlaps.begin(), report.overlaps.end());
  std::sort(report.conflicts.begin(), report.conflicts.end());
  for (std::size_t scene = 0; scene < job.file.num_scenes(); ++scene) {
    if (!known.contains(scene)) report.gaps.push_back(scene);
  }
  return report;
}

}  // namespace brachisto::sweep
