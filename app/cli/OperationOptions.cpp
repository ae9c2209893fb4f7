// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/OperationOptions.h"

#include "document/OperationText.h"

#include <algorithm>
#include <map>

namespace handwheel {

namespace {

std::string helpLine(const Parameter& parameter) {
  return "        --" + parameter.id() + (parameter.word.empty() ? "" : " " + parameter.word) + "  " +
         helpOf(parameter) + "\n";
}

}  // namespace

std::vector<OptionSpec> optionsOf(const Operation& operation, std::initializer_list<std::string_view> without) {
  std::vector<OptionSpec> all;
  for (const Parameter& parameter : operation.parameters) {
    if (std::find(without.begin(), without.end(), parameter.id()) != without.end()) continue;
    all.push_back({parameter.id(), 0, parameter.word, helpOf(parameter), parameter.formerId});
  }
  return all;
}

std::string readOptions(const Arguments& arguments, OperationValues& values) {
  for (const Parameter& parameter : values.operation().parameters) {
    if (!arguments.has(parameter.id())) continue;
    const std::string problem = readWord(values, parameter, arguments.valueOf(parameter.id()));
    if (!problem.empty()) return sentenceOf(problem);
  }
  return {};
}

std::string sentenceOf(std::string clause) {
  if (!clause.empty() && clause[0] >= 'a' && clause[0] <= 'z') clause[0] = static_cast<char>(clause[0] - 'a' + 'A');
  return clause + ".";
}

std::string stepsHelp(std::span<const Operation> operations) {
  std::string text;
  std::map<std::string, std::string> bundles;
  for (const Operation& operation : operations) {
    text += "  " + syntaxOf(operation) + "\n      " + operation.meaning + "\n";
    std::map<std::string, std::string> own;
    for (const Parameter& parameter : operation.parameters) {
      (parameter.bundle.empty() ? text : own[parameter.bundle]) += helpLine(parameter);
    }
    bundles.merge(own);
  }
  for (const auto& [name, lines] : bundles) text += "  " + name + "\n      Any of\n" + lines;
  return text;
}

}  // namespace handwheel
