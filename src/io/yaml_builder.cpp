// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// parse_yaml(): the events of yaml-cpp become a tree. No other file reads by
/// yaml-cpp. Its own tree would not do: it keeps repeated keys silently,
/// resolves aliases and sees the first document only.

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <unordered_map>

#include "brachisto/io/problem_file.hpp"
#include "io/visible_text.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

namespace {

/// Controls but tab and line feed; YAML allows no others.
bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\t' && c != '\n') || byte == 0x7F;
}

/// The bytes made fit for a parser: without a byte order mark, and CR LF turned
/// into LF.
std::string prepared_text(std::string_view text, int source) {
  if (text.size() > kMaxFileSize) {
    throw SyntaxError({source, 1, 1},
                      fmt::format("longer than {} bytes, which no problem file "
                                  "needs to be",
                                  kMaxFileSize));
  }
  text = without_byte_order_mark(text);

  std::string prepared;
  prepared.reserve(text.size());
  Position here{source, 1, 1};
  bool indenting = true;
  while (!text.empty()) {
    if (text.starts_with("\r\n")) text.remove_prefix(1);
    const char c = text.front();
    const std::size_t length = character_length(text);
    if (length == 0) {
      throw SyntaxError(here, fmt::format("byte 0x{:02x} is not UTF-8; save "
                                          "the file in the encoding UTF-8",
                                          static_cast<unsigned char>(c)));
    }
    if (is_control(c)) {
      throw SyntaxError(here, fmt::format("control character U+{:04X} is not "
                                          "allowed in a text",
                                          static_cast<unsigned char>(c)));
    }
    if (c == '\t' && indenting) {
      throw SyntaxError(here,
                        "tab in the indentation; YAML indents with "
                        "spaces");
    }
    indenting = c == '\n' || (indenting && c == ' ');
    here = c == '\n' ? Position{source, here.line + 1, 1}
                     : Position{source, here.line, here.column + 1};
    prepared.append(text, 0, length);
    text.remove_prefix(length);
  }
  return prepared;
}

/// Finds the line and the column, in characters, of bytes of a UTF-8 text.
///
/// Counts on from the last byte asked for, so that asking in order costs O(n)
/// altogether, even where all of the text is one line.
class Ruler {
 public:
  Ruler(std::string_view text, int source);

  /// Place of a byte; offsets behind the end mean the end.
  [[nodiscard]] Position position(std::size_t offset);

 private:
  struct Line {
    std::size_t offset;
    int characters;  ///< in all lines before
  };

  [[nodiscard]] bool begins_character(std::size_t i) const {
    return (static_cast<unsigned char>(text_[i]) & 0xC0U) != 0x80U;
  }

  std::string_view text_;
  int source_;
  std::vector<Line> lines_;
  std::size_t offset_ = 0;
  int characters_ = 0;  ///< in text_[0, offset_)
};

Ruler::Ruler(std::string_view text, int source) : text_(text), source_(source) {
  lines_.push_back({0, 0});
  int characters = 0;
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (begins_character(i)) ++characters;
    if (text_[i] == '\n') lines_.push_back({i + 1, characters});
  }
}

Position Ruler::position(std::size_t offset) {
  offset = std::min(offset, text_.size());
  for (; offset_ < offset; ++offset_) {
    if (begins_character(offset_)) ++characters_;
  }
  for (; offset_ > offset; --offset_) {
    if (begins_character(offset_ - 1)) --characters_;
  }
  const auto next = std::ranges::upper_bound(lines_, offset, {}, &Line::offset);
  const auto number = static_cast<int>(next - lines_.begin());
  return {source_, number, characters_ - std::prev(next)->characters + 1};
}

constexpr const char* kNoAliases =
    "aliases (*) are not allowed; repeat the value";
constexpr const char* kUnclosed = "quoted text without a closing quote";

/// True if the quote that opens at `start` is closed again. yaml-cpp takes the
/// end of the text for a closing quote.
bool quote_closes(std::string_view text, std::size_t start) {
  const char quote = text[start];
  for (std::size_t i = start + 1; i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (text[i] == quote) {
      // Two single quotes in a row stand for one of the text.
      const bool doubled = quote == '\'' && text.substr(i + 1, 1) == "'";
      if (!doubled) return true;
      ++i;
    }
  }
  return false;
}

/// What yaml-cpp objects to, in our words where its own would puzzle.
std::string reason(const YAML::ParserException& error) {
  if (error.msg == YAML::ErrorMsg::UNKNOWN_ANCHOR) return kNoAliases;
  if (error.msg == YAML::ErrorMsg::EOF_IN_SCALAR) return kUnclosed;
  return "not valid YAML: " + error.msg;
}

class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(const std::string& text, int source, Findings& findings,
              const std::string& key)
      : text_(text), ruler_(text, source), findings_(findings), key_(key) {}

  [[nodiscard]] YamlValue take() { return std::move(root_); }
  [[nodiscard]] Position position(const YAML::Mark& mark) {
    return ruler_.position(static_cast<std::size_t>(std::max(mark.pos, 0)));
  }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) {
      throw SyntaxError(position(mark),
                        "the document ended before this; a problem file "
                        "holds exactly one");
    }
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    check_properties(mark, "?", anchor);
    attach(YamlValue::of(YamlValue::Kind::Null, position(mark),
                         std::string(null_at(mark))));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse(mark, kNoAliases);
    attach(YamlValue::of(YamlValue::Kind::Refused, position(mark)));
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag,
                YAML::anchor_t anchor, const std::string& value) override {
    check_properties(mark, tag, anchor);
    check_quote(mark);
    if (tag == "?" && value == "<<" && awaits_key()) {
      refuse(mark, "merge keys (<<) are not allowed; repeat the keys");
      attach(YamlValue::of(YamlValue::Kind::Refused, position(mark)));
      return;
    }
    attach(YamlValue::of(YamlValue::Kind::Scalar, position(mark), value));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag,
                       YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(YamlValue::Kind::List, mark, tag, anchor);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag,
                  YAML::anchor_t anchor, YAML::EmitterStyle::value) override {
    open(YamlValue::Kind::Map, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  /// A map or list that is still being read.
  struct Level {
    YamlValue node;
    std::optional<Entry> pending;  ///< the key whose value comes next
    bool keep = true;              ///< whether to keep that value
    std::unordered_map<std::string, int> lines = {};  ///< of the keys so far
  };

  void refuse(const YAML::Mark& mark, std::string message) {
    findings_.add(position(mark), dotted_key(), std::move(message));
  }

  void check_properties(const YAML::Mark& mark, const std::string& tag,
                        YAML::anchor_t anchor) {
    if (anchor != 0) refuse(mark, "anchors (&) are not allowed");
    // yaml-cpp gives quoted text the tag "!", as it does after a literal "!".
    const bool literal = text_.substr(offset(mark), 1) == "!";
    if (tag != "?" && (tag != "!" || literal)) {
      refuse(mark, "tags (!) are not allowed");
    }
  }

  void check_quote(const YAML::Mark& mark) {
    const std::string_view first = text_.substr(offset(mark), 1);
    const bool quotes = first == "'" || first == "\"";
    if (!quotes || quote_closes(text_, offset(mark))) return;
    throw SyntaxError(position(mark), kUnclosed);
  }

  [[nodiscard]] std::size_t offset(const YAML::Mark& mark) const {
    return std::min(static_cast<std::size_t>(std::max(mark.pos, 0)),
                    text_.size());
  }

  /// The word null at a place; "" if something else stands there, as it does
  /// where a value is left out.
  [[nodiscard]] std::string_view null_at(const YAML::Mark& mark) const {
    constexpr std::string_view kNull = "null";
    const std::string_view rest = text_.substr(offset(mark));
    if (!rest.starts_with(kNull)) return {};
    const std::string_view after = rest.substr(kNull.size(), 1);
    return after.empty() || std::string_view(" ,]}\n").find(after) !=
                                std::string_view::npos
               ? kNull
               : std::string_view();
  }

  [[nodiscard]] bool awaits_key() const {
    return !levels_.empty() &&
           levels_.back().node.kind == YamlValue::Kind::Map &&
           !levels_.back().pending;
  }

  /// Dotted key of the value that is being read, for messages.
  [[nodiscard]] std::string dotted_key() const {
    std::string dotted = printable(key_);
    for (const Level& level : levels_) {
      if (!level.pending) continue;
      if (!dotted.empty()) dotted += '.';
      dotted += printable(level.pending->key);
    }
    return dotted;
  }

  void open(YamlValue::Kind kind, const YAML::Mark& mark,
            const std::string& tag, YAML::anchor_t anchor) {
    check_properties(mark, tag, anchor);
    if (levels_.size() == kMaxNesting) {
      throw SyntaxError(
          position(mark),
          fmt::format("maps and lists nest more than {} levels", kMaxNesting));
    }
    levels_.push_back(
        {.node = YamlValue::of(kind, position(mark)), .pending = std::nullopt});
  }

  void close() {
    YamlValue node = std::move(levels_.back().node);
    levels_.pop_back();
    attach(std::move(node));
  }

  /// Puts a finished node where it belongs: at the root, into a list, or into
  /// a map as key or value.
  void attach(YamlValue node) {
    if (levels_.empty()) {
      root_ = std::move(node);
    } else if (Level& level = levels_.back();
               level.node.kind == YamlValue::Kind::List) {
      level.node.items.push_back(std::move(node));
    } else if (!level.pending) {
      take_key(level, std::move(node));
    } else {
      // yaml-cpp places an absent value at the token that follows it.
      if (node.kind == YamlValue::Kind::Null && node.text.empty()) {
        node.position = level.pending->position;
      }
      level.pending->value = std::move(node);
      if (level.keep) level.node.entries.push_back(std::move(*level.pending));
      level.pending.reset();
    }
  }

  void take_key(Level& level, YamlValue node) {
    Position where = node.position;
    level.keep = node.kind == YamlValue::Kind::Scalar;
    if (!level.keep && node.kind != YamlValue::Kind::Refused) {
      findings_.add(where, dotted_key(),
                    fmt::format("{} stands where a key is expected",
                                kind_name(node.kind)));
    }
    level.pending = {std::move(node.text), where, {}};
    if (!level.keep) return;
    const auto [first, is_new] =
        level.lines.try_emplace(level.pending->key, where.line);
    if (is_new) return;
    level.keep = false;
    findings_.add(
        where, dotted_key(),
        fmt::format("repeated key; first given in line {}", first->second));
  }

  std::string_view text_;
  Ruler ruler_;
  Findings& findings_;
  const std::string& key_;
  int documents_ = 0;
  std::vector<Level> levels_;
  YamlValue root_;
};

}  // namespace

YamlValue parse_yaml(std::string_view bytes, int source, Findings& findings,
                     const std::string& key) {
  const std::string text = prepared_text(bytes, source);
  std::istringstream stream(text);
  TreeBuilder builder(text, source, findings, key);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::ParserException& error) {
    throw SyntaxError(builder.position(error.mark), reason(error));
  }
  return builder.take();
}

}  // namespace brachisto::io
