// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/manager.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "sweep/outcome.hpp"
#include "sweep/worker_process.hpp"

namespace brachisto::sweep {

namespace {

using Clock = std::chrono::steady_clock;

/// A worker and the chain it is at.
struct Slot {
  std::unique_ptr<WorkerProcess> worker;
  bool busy = false;
  Chain chain;
  std::size_t next = 0;  ///< the scene whose answer comes next
  std::string state;     ///< of the scene before it
  bool retrying = false;
  Clock::time_point deadline;
};

/// What made a worker useless.
struct Loss {
  std::string_view status;
  std::string message;
};

/// Chains of a shard that are not finished, in order.
class Backlog {
 public:
  Backlog(const ChainPlan& plan, const Shard& shard, std::vector<bool> finished)
      : plan_(plan), shard_(shard), finished_(std::move(finished)) {}

  /// The next chain with what is left of it, if there is one.
  std::optional<Chain> take() {
    for (; id_ < plan_.size(); ++id_) {
      if (!shard_.has(id_)) continue;
      Chain chain = plan_[id_];
      while (chain.first < chain.last && finished_[chain.first]) ++chain.first;
      if (chain.first == chain.last) continue;
      ++id_;
      return chain;
    }
    return std::nullopt;
  }

 private:
  const ChainPlan& plan_;
  Shard shard_;
  std::vector<bool> finished_;
  std::size_t id_ = 0;
};

class Manager {
 public:
  Manager(const Job& job, Store& store, const ManagerOptions& options)
      : plan_(job.file),
        store_(store),
        options_(options),
        job_line_(to_line(job)),
        backlog_(plan_, options.shard, store.finished(job.file.num_scenes())),
        slots_(static_cast<std::size_t>(options.jobs)) {
    for (std::size_t id = 0; id < plan_.size(); ++id) {
      if (!options.shard.has(id)) continue;
      counts_.scenes += plan_[id].last - plan_[id].first;
    }
    store.for_each_result(
        [&](std::size_t, const std::string& document) { count(document); });
    counts_.before = counts_.finished();
  }

  Counts run(const ProgressSink& progress) {
    while (!interrupted()) {
      bool working = false;
      for (Slot& slot : slots_) {
        if (!slot.busy) assign(slot);
        working = working || slot.busy;
      }
      if (!working) break;
      wait();
      std::vector<Answer> answers;
      for (Slot& slot : slots_) {
        if (slot.busy) attend(slot, answers);
      }
      store_.record(answers, plan_);
      for (const Answer& answer : answers) count(answer.result);
      progress(counts_);
    }
    return counts_;
  }

 private:
  [[nodiscard]] bool interrupted() const {
    return options_.interrupt != nullptr && options_.interrupt->load() != 0;
  }

  void count(const std::string& document) {
    const SweepOutcome outcome = read_outcome(document);
    const bool good = outcome.state == SweepOutcome::State::Verified;
    ++(good ? counts_.verified : counts_.failed);
    if (good && outcome.feasible) ++counts_.feasible;
  }

  void assign(Slot& slot) {
    const std::optional<Chain> chain = backlog_.take();
    if (!chain) return;
    slot.chain = *chain;
    slot.next = chain->first;
    slot.state = store_.state_of(chain->id);
    slot.retrying = false;
    send_request(slot);
  }

  /// Asks for the rest of the slot's chain.
  void send_request(Slot& slot) {
    if (!slot.worker) {
      slot.worker =
          std::make_unique<WorkerProcess>(options_.program, options_.memory);
      slot.worker->send(job_line_);
    }
    slot.worker->send(to_line(Request{slot.next, slot.chain.last, slot.state}));
    slot.worker->flush();
    slot.busy = true;
    set_deadline(slot);
  }

  void set_deadline(Slot& slot) const {
    slot.deadline =
        Clock::now() +
        std::chrono::duration_cast<Clock::duration>(
            std::chrono::duration<double>(options_.seconds_per_scene));
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
        lose(slot,
             {"worker_rubbish",
              "the worker wrote something else than "
              "an answer"},
             answers);
        return;
      }
      accept(slot, std::move(*answer), answers);
    }
    if (!slot.busy) return;
    if (slot.worker->ended()) {
      lose(slot, {"worker_lost", "the worker "}, answers);
    } else if (Clock::now() > slot.deadline) {
      lose(slot,
           {"worker_timeout",
            fmt::format("no answer within {:g} s; the worker was killed",
                        options_.seconds_per_scene)},
           answers);
    }
  }

  void accept(Slot& slot, Answer answer, std::vector<Answer>& answers) {
    slot.state = answer.state;
    slot.retrying = false;
    answers.push_back(std::move(answer));
    ++slot.next;
    slot.busy = slot.next < slot.chain.last;
    set_deadline(slot);
  }

  /// The scene is tried once more; the second time it has failed, and the next
  /// one starts cold.
  void lose(Slot& slot, Loss loss, std::vector<Answer>& answers) {
    const std::string end = slot.worker->finish();
    if (loss.status == "worker_lost") loss.message += end;
    slot.worker.reset();
    if (slot.retrying) {
      accept(
          slot,
          {slot.next, failure_json(loss.status, loss.message + ", twice"), ""},
          answers);
    } else {
      slot.retrying = true;
    }
    if (slot.busy) send_request(slot);
  }

  ChainPlan plan_;
  Store& store_;
  const ManagerOptions& options_;
  std::string job_line_;
  Backlog backlog_;
  std::vector<Slot> slots_;
  Counts counts_;
};

}  // namespace

Counts run_manager(const Job& job, Store& store, const ManagerOptions& options,
                   const ProgressSink& progress) {
  // A worker that is gone shows when its output is read.
  ::signal(SIGPIPE, SIG_IGN);
  return Manager(job, store, options).run(progress);
}

}  // namespace brachisto::sweep
