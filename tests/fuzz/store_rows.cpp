// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What managers read from workers and stores, and workers from managers:
// answers, results, states, requests and jobs.

#include <cstddef>
#include <cstdint>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/model/scene.hpp"
#include "fuzz/law.hpp"
#include "sweep/job.hpp"
#include "sweep/message.hpp"
#include "sweep/outcome.hpp"

namespace brachisto::fuzz {

namespace {

using namespace sweep;

void read_answer(std::string_view line) {
  const std::optional<Answer> answer = answer_from_line(line);
  if (!answer) return;
  law(is_outcome(answer->result), "what is stored can be read again");
  const std::string again = to_line(*answer);
  const auto same = answer_from_line({again.data(), again.size() - 1});
  law(same && same->scene == answer->scene && same->result == answer->result &&
          same->state == answer->state,
      "an answer survives a line");
}

void read_result(const std::string& document) {
  if (!is_outcome(document)) return;
  const SweepOutcome outcome = read_outcome(document);
  law(outcome.state != SweepOutcome::State::Missing, "a result is one");
  const auto json = parse_bounded_json(document);
  law(json.has_value(), "a result is within the bounds of JSON");
  const auto copy = *json;  // all of these are recursive
  law(copy == *json && copy.dump() == json->dump(), "a copy is the same");
}

void read_state(const std::string& text) {
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  try {
    const Neighbour read = neighbour_from_state(text, scene);
    const Neighbour again = neighbour_from_state(to_state(read), scene);
    law(again.mesh.boundaries == read.mesh.boundaries &&
            again.point.x == read.point.x &&
            again.point.lambda == read.point.lambda &&
            again.arcs.size() == read.arcs.size(),
        "a state survives");
  } catch (const std::exception&) {
  }
}

void read_request(std::string_view line) {
  try {
    (void)to_line(request_from_line(line));
  } catch (const std::exception&) {
  }
}

void read_job(const std::string& line) {
  // Large sweeps are as slow as they are allowed to be.
  if (line.find("count") != std::string::npos) return;
  try {
    const Job job = job_from_line(line);
    law(input_hash(job_from_line(to_line(job)).file) == input_hash(job.file),
        "a job survives a line");
  } catch (const JobError&) {
  } catch (const io::InputError&) {
  } catch (const io::IoError&) {
  }
}

}  // namespace

}  // namespace brachisto::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  brachisto::fuzz::read_answer(text);
  brachisto::fuzz::read_result(text);
  brachisto::fuzz::read_state(text);
  brachisto::fuzz::read_request(text);
  brachisto::fuzz::read_job(text);
  return 0;
}
