// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

struct OptionSpec {
  std::string_view name;   // without the dashes
  char letter = 0;         // short form, 0: none
  std::string_view value;  // what follows, for the help; empty: nothing follows
  std::string_view help;
};

// What one command takes. The parser and the help page are both made from it.
struct CommandSpec {
  std::string_view name;
  std::string_view operands;  // separated by blanks, as the help shows them; all are required but a last "[…...]"
  std::string_view summary;
  std::vector<OptionSpec> options;
};

// Words of a command line, sorted out. Kept as bytes, so that any file name is possible.
struct Arguments {
  std::vector<std::string> operands;
  std::multimap<std::string, std::string, std::less<>> options;  // by long name; an empty value for those without one
  std::string problem;                                           // a sentence when the words do not fit; else empty

  bool has(std::string_view name) const { return options.contains(name); }
  std::string valueOf(std::string_view name) const;  // the last one given; empty when none was
  std::vector<std::string> valuesOf(std::string_view name) const;
};

// The whole word as a number, in any locale; for doubles also "inf" and "nan". False when it is none.
template <class Number>
bool readNumber(std::string_view word, Number& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

// "--name value", "--name=value", "-n value", "-nvalue"; "--" ends the options.
Arguments parseArguments(const CommandSpec& command, std::span<char* const> words);

std::string usageLine(const CommandSpec& command);
std::string helpPage(const CommandSpec& command, const std::string& details = {});

}  // namespace handwheel
