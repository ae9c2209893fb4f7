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

// One option of a command.
struct OptionSpec {
  std::string_view name;   // without the dashes
  char letter = 0;         // short form; 0: none
  std::string_view value;  // name of the option's value in the help; empty: the option takes no value
  std::string help;
  std::string_view formerName = {};  // an earlier name, accepted but not shown in the help
};

// The syntax of one command. Both the parser and the help page use it.
struct CommandSpec {
  std::string_view name;
  // Names of the operands, separated by spaces as in the help; all are required except a last "[…...]", which may be
  // repeated.
  std::string_view operands;
  std::string_view summary;
  std::vector<OptionSpec> options;
  std::string_view usage = {};  // replaces the usage line after the name, for options that depend on one another
};

// The parsed words of a command line. They are kept as bytes, so that any file name is possible.
struct Arguments {
  std::vector<std::string> operands;
  // Values of the options by long name; the value is empty for an option that takes none.
  std::multimap<std::string, std::string, std::less<>> options;
  std::string problem;  // a sentence if the words do not match the syntax; otherwise empty

  bool has(std::string_view name) const { return options.contains(name); }
  std::string valueOf(std::string_view name) const;  // the last value given; empty if there is none
  std::vector<std::string> valuesOf(std::string_view name) const;
};

// Parses a whole word as a number, independently of the locale. Accepts "inf" and "nan" for doubles. Returns false if
// the word is not a number.
template <class Number>
bool readNumber(std::string_view word, Number& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

// Parses the words of a command. Accepts "--name value", "--name=value", "-n value", "-nvalue"; "--" ends the options.
Arguments parseArguments(const CommandSpec& command, std::span<char* const> words);

// Returns one line with the syntax of the command.
std::string usageLine(const CommandSpec& command);
// Returns the text that --help prints; details are inserted before the options.
std::string helpPage(const CommandSpec& command, const std::string& details = {});

}  // namespace handwheel
