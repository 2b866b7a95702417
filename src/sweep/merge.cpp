// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/merge.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

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

/// Results that are known, and what the parts add to them.
class Collection {
 public:
  explicit Collection(Store& target) {
    target.for_each_result([&](std::size_t scene, const std::string& document) {
      known_.emplace(scene, document);
    });
  }

  void add(Store& part, const ChainPlan& plan, MergeReport& report) {
    const std::size_t before = added_.size();
    part.for_each_result([&](std::size_t scene, const std::string& document) {
      const auto [place, is_new] = known_.emplace(scene, document);
      if (is_new) {
        added_.push_back({scene, document, std::nullopt});
      } else if (essence(place->second) == essence(document)) {
        report.overlaps.push_back(scene);
      } else {
        report.conflicts.push_back(scene);
      }
    });
    // The last scene of a chain that is not finished brings its state along.
    for (std::size_t i = before; i < added_.size(); ++i) {
      const Chain chain = plan.of_scene(added_[i].scene);
      const bool last =
          i + 1 == added_.size() || added_[i + 1].scene != added_[i].scene + 1;
      if (last && added_[i].scene + 1 < chain.last) {
        added_[i].state = part.state_after(chain.id, added_[i].scene);
      }
    }
  }

  [[nodiscard]] bool has(std::size_t scene) const {
    return known_.contains(scene);
  }
  [[nodiscard]] std::vector<Answer> added() && {
    std::sort(
        added_.begin(), added_.end(),
        [](const Answer& a, const Answer& b) { return a.scene < b.scene; });
    return std::move(added_);
  }

 private:
  std::map<std::size_t, std::string> known_;
  std::vector<Answer> added_;
};

}  // namespace

std::vector<Store> open_parts(const std::vector<std::filesystem::path>& parts,
                              const StoreInfo& target) {
  std::vector<Store> stores;
  stores.reserve(parts.size());
  for (const auto& part : parts) stores.push_back(open_part(part, target));
  return stores;
}

MergeReport merge(std::vector<Store>& parts, Store& target, const Job& job) {
  const ChainPlan plan(job.file);
  MergeReport report;
  Collection collection(target);
  for (Store& part : parts) collection.add(part, plan, report);
  for (std::size_t scene = 0; scene < job.file.num_scenes(); ++scene) {
    if (!collection.has(scene)) report.gaps.push_back(scene);
  }
  report.damaged = may_be_missing(target.damage(), report.gaps);
  for (const Store& part : parts) {
    report.damaged =
        report.damaged || may_be_missing(part.damage(), report.gaps);
  }
  const std::vector<Answer> added = std::move(collection).added();
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
  std::sort(report.overlaps.begin(), report.overlaps.end());
  std::sort(report.conflicts.begin(), report.conflicts.end());
  return report;
}

}  // namespace brachisto::sweep
