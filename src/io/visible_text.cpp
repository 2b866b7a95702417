// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/visible_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <vector>

namespace brachisto::io {

namespace {

/// Whether a terminal would obey a character instead of showing it.
bool is_obeyed(std::string_view character) {
  const auto byte = static_cast<unsigned char>(character.front());
  const bool c0 = byte < 0x20 || byte == 0x7F;
  const bool c1 = character >= "\u0080" && character <= "\u009F";
  const bool separates = character == "\u2028" || character == "\u2029";
  const bool turns = (character >= "\u202A" && character <= "\u202E") ||
                     (character >= "\u2066" && character <= "\u2069");
  return c0 || c1 || separates || turns;
}

std::string shown(std::string_view text, std::string_view kept,
                  std::size_t most) {
  std::string out;
  for (std::size_t count = 0; !text.empty(); ++count) {
    if (count == most) return out + "…";
    const std::size_t length = character_length(text);
    const std::string_view character = text.substr(0, length > 0 ? length : 1);
    const bool stays = kept.find(character) != std::string_view::npos;
    if (length > 0 && (stays || !is_obeyed(character))) {
      out += character;
    } else {
      for (const char c : character) {
        out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
      }
    }
    text.remove_prefix(character.size());
  }
  return out;
}

}  // namespace

std::size_t character_length(std::string_view text) {
  struct Form {
    unsigned char first_low, first_high, second_low, second_high;
    std::size_t length;
  };
  static constexpr std::array<Form, 9> kForms{{{0x00, 0x7F, 0, 0, 1},
                                               {0xC2, 0xDF, 0x80, 0xBF, 2},
                                               {0xE0, 0xE0, 0xA0, 0xBF, 3},
                                               {0xE1, 0xEC, 0x80, 0xBF, 3},
                                               {0xED, 0xED, 0x80, 0x9F, 3},
                                               {0xEE, 0xEF, 0x80, 0xBF, 3},
                                               {0xF0, 0xF0, 0x90, 0xBF, 4},
                                               {0xF1, 0xF3, 0x80, 0xBF, 4},
                                               {0xF4, 0xF4, 0x80, 0x8F, 4}}};
  const auto within = [&](std::size_t i, unsigned char low,
                          unsigned char high) {
    if (i >= text.size()) return false;
    const auto byte = static_cast<unsigned char>(text[i]);
    return low <= byte && byte <= high;
  };
  for (const Form& form : kForms) {
    if (!within(0, form.first_low, form.first_high)) continue;
    if (form.length > 1 && !within(1, form.second_low, form.second_high)) {
      return 0;
    }
    for (std::size_t i = 2; i < form.length; ++i) {
      if (!within(i, 0x80, 0xBF)) return 0;
    }
    return form.length;
  }
  return 0;
}

std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

std::string visible(std::string_view text, std::size_t most) {
  return shown(text, "", most);
}

std::string visible_lines(std::string_view text) {
  return shown(text, "\t\n", std::numeric_limits<std::size_t>::max());
}

namespace {

bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) ==
         std::tolower(static_cast<unsigned char>(b));
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  // Row i holds the distances of the first i letters of a to each beginning
  // of b; a swap looks two rows back.
  std::vector<int> before(b.size() + 1);
  std::vector<int> above(b.size() + 1);
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced =
          above[j - 1] + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) &&
                           same_letter(a[i - 2], b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

std::string_view nearest(std::string_view word,
                         std::span<const std::string_view> candidates) {
  std::string_view best;
  int best_distance = 0;
  for (const std::string_view candidate : candidates) {
    const auto [shorter, longer] = std::minmax({word.size(), candidate.size()});
    const auto allowed =
        static_cast<int>(std::min((shorter + 2) / 3, longer - 1));
    // Skips the work on words of absurd length.
    if (longer - shorter > static_cast<std::size_t>(allowed)) continue;
    const int distance = edit_distance(word, candidate);
    if (distance > allowed) continue;
    if (best.empty() || distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string suggestion(std::string_view word,
                       std::span<const std::string_view> candidates) {
  const std::string_view found = nearest(word, candidates);
  return found.empty() ? "" : fmt::format("; did you mean {}?", found);
}

std::string unknown_word(std::string_view word, std::string_view expected,
                         std::span<const std::string_view> known) {
  return fmt::format("{} was read; expected {}{}", in_quotes(word), expected,
                     suggestion(word, known));
}

std::string in_quotes(std::string_view text) {
  return '"' + printable(text) + '"';
}

std::string printable(std::string_view text) {
  constexpr std::size_t kMostCharacters = 40;
  return visible(text, kMostCharacters);
}

}  // namespace brachisto::io
