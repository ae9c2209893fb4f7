// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Arguments.h"

#include <algorithm>

namespace handwheel {

namespace {

// Returns the number of characters of a text in UTF-8, by counting the bytes that do not continue a character.
std::size_t charactersOf(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

const OptionSpec* findOption(const CommandSpec& command, std::string_view word) {
  const bool isLong = word.starts_with("--");
  const auto found = std::find_if(command.options.begin(), command.options.end(), [&](const OptionSpec& o) {
    return isLong ? word.substr(2) == o.name || (!o.formerName.empty() && word.substr(2) == o.formerName)
                  : o.letter != 0 && word[1] == o.letter;
  });
  return found == command.options.end() ? nullptr : &*found;
}

bool takesAnyMore(const CommandSpec& command) {
  return command.operands.ends_with("...]");
}

std::size_t operandCount(const CommandSpec& command) {
  if (command.operands.empty()) return 0;
  const auto words = std::count(command.operands.begin(), command.operands.end(), ' ') + 1;
  return static_cast<std::size_t>(words - (takesAnyMore(command) ? 1 : 0));
}

// Parses one option and, if it has one, its value. Returns the number of words used, 0 on an error.
std::size_t takeOption(const CommandSpec& command, std::span<char* const> words, Arguments& result) {
  const std::string_view word = words[0];
  const std::size_t equals = word.starts_with("--") ? word.find('=') : std::string_view::npos;
  const std::string_view name = word.substr(0, equals);
  const OptionSpec* option = findOption(command, name);
  if (!option) {
    result.problem = "There is no option " + std::string(name) + ".";
    return 0;
  }
  std::string& value = result.options.emplace(option->name, std::string())->second;
  const bool isShort = !word.starts_with("--");
  if (option->value.empty()) {
    if (equals == std::string_view::npos && !(isShort && word.size() > 2)) return 1;
    result.problem = "The option " + std::string(name.substr(0, isShort ? 2 : name.size())) + " takes no value.";
    return 0;
  }
  std::size_t used = 1;
  if (equals != std::string_view::npos) {
    value = word.substr(equals + 1);
  } else if (isShort && word.size() > 2) {
    value = word.substr(2);
  } else if (words.size() > 1) {
    value = words[1];
    used = 2;
  }
  if (!value.empty()) return used;
  result.problem = "The option " + std::string(name) + " needs a value: " + std::string(option->value) + ".";
  return 0;
}

}  // namespace

std::string Arguments::valueOf(std::string_view name) const {
  const std::vector<std::string> values = valuesOf(name);
  return values.empty() ? std::string() : values.back();
}

std::vector<std::string> Arguments::valuesOf(std::string_view name) const {
  std::vector<std::string> values;
  const auto [first, last] = options.equal_range(name);
  std::transform(first, last, std::back_inserter(values), [](const auto& option) { return option.second; });
  return values;
}

Arguments parseArguments(const CommandSpec& command, std::span<char* const> words) {
  Arguments result;
  bool optionsEnded = false;
  while (!words.empty()) {
    const std::string_view word = words[0];
    std::size_t used = 1;
    if (!optionsEnded && word == "--") {
      optionsEnded = true;
    } else if (!optionsEnded && word.size() > 1 && word[0] == '-') {
      used = takeOption(command, words, result);
      if (used == 0) return result;
    } else {
      result.operands.emplace_back(word);
    }
    words = words.subspan(used);
  }
  const bool tooFew = result.operands.size() < operandCount(command);
  const bool tooMany = result.operands.size() > operandCount(command) && !takesAnyMore(command);
  if ((tooFew || tooMany) && !result.has("help")) {
    result.problem = "The command " + std::string(command.name) + (tooFew ? " needs " : " takes no more than ") +
                     std::string(command.operands) + ".";
  }
  return result;
}

std::string usageLine(const CommandSpec& command) {
  std::string line = "handwheel " + std::string(command.name);
  if (!command.usage.empty()) return line + " " + std::string(command.usage);
  if (!command.operands.empty()) line += " " + std::string(command.operands);
  for (const OptionSpec& o : command.options) {
    if (o.name == "help") continue;
    const bool isRequired = o.name == "output";
    const std::string text = (o.letter ? "-" + std::string(1, o.letter) : "--" + std::string(o.name)) +
                             (o.value.empty() ? "" : " " + std::string(o.value));
    line += isRequired ? " " + text : " [" + text + "]";
  }
  return line;
}

std::string helpPage(const CommandSpec& command, const std::string& details) {
  std::string page =
      "Usage: " + usageLine(command) + "\n\n" + std::string(command.summary) + "\n" + details + "\nOptions:\n";
  std::vector<std::string> left;
  std::size_t width = 0;
  for (const OptionSpec& o : command.options) {
    left.push_back((o.letter ? "-" + std::string(1, o.letter) + ", --" : "    --") + std::string(o.name) +
                   (o.value.empty() ? "" : " " + std::string(o.value)));
    width = std::max(width, charactersOf(left.back()));
  }
  for (std::size_t i = 0; i < left.size(); ++i) {
    page += "  " + left[i] + std::string(width + 2 - charactersOf(left[i]), ' ') +
            std::string(command.options[i].help) + "\n";
  }
  return page;
}

}  // namespace handwheel
