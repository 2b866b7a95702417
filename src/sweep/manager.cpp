// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/manager.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <csignal>
#include <memory>
#include <optional>
#include <utility>

#include "sweep/outcome.hpp"
#include "sweep/worker.hpp"

namespace brachisto::sweep {

namespace {

/// A worker and the run of a chain it is at.
struct Slot {
  std::unique_ptr<WorkerProcess> worker;
  bool busy = false;
  Chain run;
  std::size_t next = 0;  ///< the scene whose answer comes next, maybe one of
                         ///< those before the run that lead up to it
  std::string state;     ///< of the scene before it
  bool retrying = false;
  WallClock::time_point deadline;
};

/// Scenes of a shard that have no result, in runs of one chain each.
class Backlog {
 public:
  Backlog(const ChainPlan& plan, const Shard& shard, std::vector<bool> finished)
      : plan_(plan), shard_(shard), finished_(std::move(finished)) {}

  /// The next run, if there is one, as part of its chain.
  std::optional<Chain> take() {
    for (; id_ < plan_.size(); ++id_, place_ = 0) {
      if (!shard_.has(id_)) continue;
      const Chain chain = plan_[id_];
      std::size_t first = std::max(place_, chain.first);
      while (first < chain.last && finished_[first]) ++first;
      if (first == chain.last) continue;
      place_ = first;
      while (place_ < chain.last && !finished_[place_]) ++place_;
      return Chain{id_, first, place_};
    }
    return std::nullopt;
  }

 private:
  const ChainPlan& plan_;
  Shard shard_;
  std::vector<bool> finished_;
  std::size_t id_ = 0;
  std::size_t place_ = 0;  ///< within the chain, or before it
};

class Manager {
 public:
  Manager(const Job& job, Store& store, const ManagerOptions& options)
      : plan_(job.file),
        warm_start_(job.file.warm_start()),
        store_(store),
        options_(options),
        job_line_(to_line(job)),
        backlog_(plan_, options.shard, count_finished(job)),
        slots_(static_cast<std::size_t>(options.jobs)) {
    for (std::size_t id = 0; id < plan_.size(); ++id) {
      if (!options.shard.has(id)) continue;
      counts_.scenes += plan_[id].last - plan_[id].first;
    }
  }

  Counts run(const ProgressSink& progress) {
    while (!interrupted() && !over(kGrace)) {
      bool working = false;
      for (Slot& slot : slots_) {
        if (!slot.busy && !over(0.0)) assign(slot);
        working = working || slot.busy;
      }
      if (!working) break;
      wait();
      std::vector<Answer> answers;
      for (Slot& slot : slots_) {
        if (slot.busy) attend(slot, answers);
      }
      keep(answers);
      progress(counts_);
    }
    if (!interrupted()) keep(held_);
    return counts_;
  }

 private:
  // What workers have for an end in order [s].
  static constexpr double kGrace = 0.5;

  [[nodiscard]] bool interrupted() const {
    return options_.interrupt != nullptr && options_.interrupt->load() != 0;
  }

  /// Whether the whole has ended, and so long ago.
  [[nodiscard]] bool over(double seconds) const {
    return limited() && seconds_since(options_.end) >= seconds;
  }
  [[nodiscard]] bool limited() const {
    return options_.end != WallClock::time_point::max();
  }

  void keep(const std::vector<Answer>& answers) {
    store_.record(answers, plan_);
    for (const Answer& answer : answers) count(answer.scene, answer.outcome);
  }

  /// Counts what is there. \return whether each scene has a result
  [[nodiscard]] std::vector<bool> count_finished(const Job& job) {
    std::vector<bool> finished(job.file.num_scenes());
    store_.for_each_result([&](std::size_t scene, const std::string& document) {
      finished.at(scene) = true;
      if (options_.shard.has(plan_.of_scene(scene).id)) {
        count(scene, read_outcome(document));
      }
    });
    counts_.before = counts_.finished();
    return finished;
  }

  void count(std::size_t scene, const SweepOutcome& outcome) {
    if (outcome.state == SweepOutcome::State::Verified) {
      ++counts_.verified;
      if (outcome.feasible) ++counts_.feasible;
      return;
    }
    ++counts_.failed;
    if (counts_.failures.size() < Counts::kShownFailures) {
      counts_.failures.push_back({scene, outcome.status, outcome.message});
    }
  }

  void assign(Slot& slot) {
    const std::optional<Chain> run = backlog_.take();
    if (!run) return;
    slot.run = *run;
    slot.next = run->first;
    slot.state.clear();
    // From where the numbers come out as in one go: what the scene before left
    // or, if that is not known, what the scenes before it lead to once more.
    for (; warm_start_ && slot.next > plan_[run->id].first; --slot.next) {
      if (auto state = store_.state_after(run->id, slot.next - 1)) {
        slot.state = *std::move(state);
        break;
      }
    }
    slot.retrying = false;
    send_request(slot);
  }

  /// Asks for the rest of the slot's run.
  void send_request(Slot& slot) {
    if (!slot.worker) {
      slot.worker =
          std::make_unique<WorkerProcess>(options_.program, options_.memory);
      slot.worker->send(job_line_);
    }
    Request request{slot.next, slot.run.last, slot.state};
    if (limited()) request.seconds = seconds_until(options_.end);
    slot.worker->send(to_line(request));
    slot.worker->flush();
    slot.busy = true;
    set_deadline(slot);
  }

  void set_deadline(Slot& slot) const {
    slot.deadline = seconds_from_now(options_.seconds_per_scene);
  }

  /// Until a worker says something, or for a tenth of a second.
  void wait() {
    constexpr int kMilliseconds = 100;
    std::vector<pollfd> files;
    for (const Slot& slot : slots_) {
      if (!slot.busy) continue;
      files.push_back({slot.worker->output(), POLLIN, 0});
      if (slot.worker->has_mail()) {
        files.push_back({slot.worker->input(), POLLOUT, 0});
      }
    }
    // A signal ends the call, which is just right.
    (void)::poll(files.data(), files.size(), kMilliseconds);
  }

  void attend(Slot& slot, std::vector<Answer>& answers) {
    slot.worker->flush();
    for (const std::string& line : slot.worker->read_lines()) {
      std::optional<Answer> answer = answer_from_line(line);
      if (!slot.busy || !answer || answer->scene != slot.next) {
        lose(slot, "worker_rubbish",
             "the worker wrote something else than an answer", answers);
        return;
      }
      // Whoever answers proves that workers can.
      losses_in_a_row_ = 0;
      answers.insert(answers.end(), held_.begin(), held_.end());
      held_.clear();
      std::string state = answer->state.value_or("");
      if (!warm_start_) answer->state.reset();  // nobody asks for it
      if (slot.next >= slot.run.first) answers.push_back(*std::move(answer));
      advance(slot, std::move(state));
    }
    if (!slot.busy) return;
    if (slot.worker->ended()) {
      lose(slot, "worker_lost", "the worker " + slot.worker->finish(), answers);
    } else if (WallClock::now() > slot.deadline) {
      lose(slot, "worker_timeout",
           fmt::format("no answer within {:g} s; the worker was killed",
                       options_.seconds_per_scene),
           answers);
    }
  }

  void advance(Slot& slot, std::string state) {
    slot.state = std::move(state);
    slot.retrying = false;
    ++slot.next;
    slot.busy = slot.next < slot.run.last;
    set_deadline(slot);
  }

  /// The scene is tried once more; the second time it has failed, and the next
  /// one starts cold.
  void lose(Slot& slot, const char* status, const std::string& message,
            std::vector<Answer>& answers) {
    slot.worker.reset();
    if (++losses_in_a_row_ >= 4 + 2 * options_.jobs) {
      store_.record(answers, plan_);
      throw WorkersFail(fmt::format(
          "{} workers failed in a row, the last one at scene {}: {}{}. What was"
          " recorded before is kept; --resume goes on",
          losses_in_a_row_, slot.next, message, bound_in_words()));
    }
    if (slot.retrying) {
      // Held back until some worker answers: it may not be the scene's fault.
      if (slot.next >= slot.run.first) {
        const std::string result = failure_json(status, message + ", twice");
        held_.push_back({slot.next, result, "", read_outcome(result)});
      }
      advance(slot, "");
    } else {
      slot.retrying = true;
    }
    if (slot.busy) send_request(slot);
  }

  /// On the address space of a worker, which may be why it ends.
  [[nodiscard]] std::string bound_in_words() const {
    return options_.memory == 0
               ? ""
               : fmt::format(" (with --memory {})", options_.memory >> 20);
  }

  ChainPlan plan_;
  bool warm_start_;
  Store& store_;
  const ManagerOptions& options_;
  std::string job_line_;
  Counts counts_;
  Backlog backlog_;
  std::vector<Slot> slots_;
  std::vector<Answer> held_;  ///< failures that are not recorded yet
  int losses_in_a_row_ = 0;
};

}  // namespace

Counts run_manager(const Job& job, Store& store, const ManagerOptions& options,
                   const ProgressSink& progress) {
  // A worker that is gone shows when its output is read.
  ::signal(SIGPIPE, SIG_IGN);
  return Manager(job, store, options).run(progress);
}

}  // namespace brachisto::sweep
