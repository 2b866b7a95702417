// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/merge.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>

namespace brachisto::sweep {

namespace {

/// A result without what differs from run to run.
nlohmann::json essence(const std::string& document) {
  nlohmann::json json = nlohmann::json::parse(document);
  json.erase("seconds");
  return json;
}

/// Whether scenes without a result may have had one.
bool may_be_missing(const Damage& damage,
                    const std::vector<std::size_t>& gaps) {
  const bool anywhere =
      damage.journal_lost || damage.strays > 0 || !damage.structure.empty();
  return std::ranges::any_of(gaps, [&](std::size_t scene) {
    return anywhere || damage.scenes.contains(scene);
  });
}

Store open_part(const std::filesystem::path& part, const StoreInfo& target) {
  Store store = Store::open(part, Database::Access::ReadOnly);
  const std::string name = (part / Store::kFileName).string();
  if (store.info().input_hash != target.input_hash) {
    throw StoreError(
        name + ": of another sweep: " +
        difference(store.job().file, job_from_line(target.job).file));
  }
  if (store.info().version != target.version) {
    throw StoreError(name + ": made by brachisto " + store.info().version +
                     ", the sweep that it is to be part of by " +
                     target.version);
  }
  return store;
}

/// The last scene of a chain that is not finished brings its state along.
void add_states(std::span<Answer> added, Store& part, const ChainPlan& plan) {
  for (std::size_t i = 0; i < added.size(); ++i) {
    const std::size_t scene = added[i].scene;
    const Chain chain = plan.of_scene(scene);
    const bool last = i + 1 == added.size() || added[i + 1].scene != scene + 1;
    if (last && scene + 1 < chain.last) {
      added[i].state = part.state_after(chain.id, scene);
    }
  }
}

}  // namespace

std::vector<Store> open_parts(const std::vector<std::filesystem::path>& parts,
                              const StoreInfo& target) {
  std::vector<Store> stores;
  stores.reserve(parts.size());
  for (auto part = parts.begin(); part != parts.end(); ++part) {
    const bool again = std::any_of(parts.begin(), part, [&](const auto& other) {
      std::error_code unknown;
      return std::filesystem::equivalent(other, *part, unknown);
    });
    if (!again) stores.push_back(open_part(*part, target));
  }
  return stores;
}

MergeReport merge(std::vector<Store>& parts, Store& target, const Job& job) {
  const ChainPlan plan(job.file);
  MergeReport report;
  std::map<std::size_t, std::string> known;
  std::set<std::size_t> in_parts;
  std::vector<Answer> added;
  target.for_each_result([&](std::size_t scene, const std::string& document) {
    known.emplace(scene, document);
  });
  for (Store& part : parts) {
    const std::size_t before = added.size();
    part.for_each_result([&](std::size_t scene, const std::string& document) {
      const auto [place, is_new] = known.emplace(scene, document);
      if (is_new) {
        added.push_back({scene, document, std::nullopt});
      } else {
        const bool alike = essence(place->second) == essence(document);
        if (!alike) {
          report.conflicts.push_back(scene);
        } else if (in_parts.contains(scene)) {
          report.overlaps.push_back(scene);
        }
      }
      in_parts.insert(scene);
    });
    add_states(std::span(added).subspan(before), part, plan);
  }
  for (std::size_t scene = 0; scene < job.file.num_scenes(); ++scene) {
    if (!known.contains(scene)) report.gaps.push_back(scene);
  }
  report.damaged = may_be_missing(target.damage(), report.gaps);
  for (const Store& part : parts) {
    report.damaged =
        report.damaged || may_be_missing(part.damage(), report.gaps);
  }
  std::ranges::sort(added, {}, &Answer::scene);
  std::vector<std::size_t> replaced;
  for (const Answer& answer : added) {
    if (target.damage().scenes.contains(answer.scene)) {
      replaced.push_back(answer.scene);
    }
  }
  target.forget(replaced);
  target.record(added, plan);
  target.set_shard(kMerged);
  report.added = added.size();
  std::ranges::sort(report.overlaps);
  std::ranges::sort(report.conflicts);
  return report;
}

}  // namespace brachisto::sweep
