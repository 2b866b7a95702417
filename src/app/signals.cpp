// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/signals.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <ctime>
#include <string_view>

#include "app/exit_code.hpp"
#include "brachisto/solvers/status.hpp"
#include "study/within_limits.hpp"

namespace brachisto::app {

namespace {

std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free,
              "a signal handler may touch lock-free atomics only");

// What is left for an end in order [s]; to end the process takes time too. It
// is processor time, which on a busy machine comes more slowly than the wall's;
// a process that waits instead of working is not waited for much longer.
constexpr double kGrace = 0.5;
constexpr double kPatience = 20.0 * kGrace;

// All that the handler touches: written before the timer is set, and left alone
// until it is deleted.
struct Ending {
  std::string message, document;
};
Ending at_limit, at_signal;
std::atomic<bool> in_force{false}, hurrying{false};
// Of the wall: at the limit, and then when patience ends. Of the thread that
// solves: when the grace ends.
timer_t wall_timer, work_timer;

itimerspec once_after(double seconds) {
  itimerspec time = {};
  const double whole = std::floor(seconds);
  time.it_value.tv_sec = static_cast<time_t>(whole);
  time.it_value.tv_nsec = static_cast<long>((seconds - whole) * 1e9);
  return time;
}

void put(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

void set(timer_t timer, double seconds) {
  const itimerspec time = once_after(seconds);
  ::timer_settime(timer, 0, &time, nullptr);
}

/// From now on there is little time.
void hurry() {
  if (!in_force.load() || hurrying.exchange(true)) return;
  set(work_timer, kGrace);
  set(wall_timer, kPatience);
}

extern "C" void on_timer(int) {
  if (!hurrying.load()) return hurry();
  const int signal = received.load();
  const Ending& ending = signal != 0 ? at_signal : at_limit;
  put(STDERR_FILENO, ending.message);
  put(STDOUT_FILENO, ending.document);
  ::_exit(signal != 0 ? kSignalBase + signal : kLimit);
}

Ending ending(Status status, std::string_view why, bool json) {
  const std::string message = fmt::format(
      "brachisto: {}, and the solve did not end in order in time", why);
  return {message + "\n",
          json ? failure_document(name(status), message) : std::string{}};
}

double now() {
  timespec time = {};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) +
         1e-9 * static_cast<double>(time.tv_nsec);
}

extern "C" void handle(int signal) {
  // Only the handler touches it, and signals are blocked in it.
  static double first = 0.0;
  // `timeout` sends each signal twice, to the process and to its group; a
  // person needs longer.
  constexpr double kTwice = 0.2;  // [s]
  if (received.load() == 0) {
    first = now();
  } else if (now() - first > kTwice) {
    std::signal(signal, SIG_DFL);
    ::raise(signal);
    return;
  }
  received.store(signal);
  hurry();
}

}  // namespace

const std::atomic<int>& catch_signals() {
  struct sigaction action = {};
  action.sa_handler = handle;
  sigemptyset(&action.sa_mask);
  sigaddset(&action.sa_mask, SIGINT);
  sigaddset(&action.sa_mask, SIGTERM);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return received;
}

LastResort::LastResort(double seconds, bool json) {
  at_limit = ending(Status::TimeLimit, time_limit_reached(seconds), json);
  at_signal = ending(Status::Interrupted, "stopped by a signal", json);
  struct sigaction action = {};
  action.sa_handler = on_timer;
  sigemptyset(&action.sa_mask);
  sigaction(SIGALRM, &action, nullptr);
  sigevent event = {};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGALRM;
  if (::timer_create(CLOCK_MONOTONIC, &event, &wall_timer) != 0) return;
  if (::timer_create(CLOCK_THREAD_CPUTIME_ID, &event, &work_timer) != 0) {
    ::timer_delete(wall_timer);
    return;
  }
  hurrying = false;
  in_force = true;
  // Beyond a century nobody waits, and the seconds of the timer end.
  constexpr double kForever = 3e9;
  if (seconds < kForever) set(wall_timer, seconds);
}

LastResort::~LastResort() {
  if (!in_force.exchange(false)) return;
  ::timer_delete(work_timer);
  ::timer_delete(wall_timer);
}

}  // namespace brachisto::app
