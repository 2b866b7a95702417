// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/damage.hpp"

#include <fmt/format.h>

#include "app/exit_code.hpp"
#include "app/terminal.hpp"

namespace brachisto::app {

void tell_damage(const sweep::Store& store, std::string_view remedy) {
  if (!store.damage()) return;
  tell(fmt::format("{}\n{}", store.damage_text(), remedy));
}

int exit_code(const sweep::Store& store) {
  tell_damage(store);
  return store.damage() ? kIoError : kSuccess;
}

}  // namespace brachisto::app
