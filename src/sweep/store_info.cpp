// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/provenance.hpp"
#include "sweep/store.hpp"

namespace brachisto::sweep {

StoreInfo store_info(const Job& job, const std::string& shard) {
  return {.job = to_line(job),
          .input_hash = input_hash(job.file),
          .version = report::provenance().brachisto,
          .shard = shard,
          .provenance = report::provenance_json(),
          .num_scenes = job.file.num_scenes()};
}

}  // namespace brachisto::sweep
