// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/RapidNames.h"

#include "robot/posts/PostText.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kLongestRapidSuffix = 7;  // "_module"
constexpr std::size_t kLongestShared = kLongestRapidName - kLongestRapidSuffix;
constexpr const char* kFramePrefix = "wobj_";
// Words of the language that a path may be called, and the procedure that a task begins with.
constexpr const char* kRapidWords[] = {
    "alias",  "and",    "backward", "case",    "connect",   "const",    "default",   "div",       "do",      "else",
    "elseif", "endfor", "endfunc",  "endif",   "endmodule", "endproc",  "endrecord", "endtest",   "endtrap", "endwhile",
    "error",  "exit",   "false",    "for",     "from",      "func",     "goto",      "if",        "inout",   "local",
    "main",   "mod",    "module",   "movej",   "movel",     "nostepin", "not",       "noview",    "or",      "pers",
    "proc",   "raise",  "readonly", "record",  "retry",     "return",   "step",      "sysmodule", "test",    "then",
    "to",     "trap",   "true",     "trynext", "undo",      "var",      "viewonly",  "while",     "with",    "xor"};

// Data that every controller has: a frame is not to hide them.
bool isStandardData(const std::string& name) {
  const std::size_t letters = std::min(name.find_first_of("0123456789"), name.size());
  const std::string head = name.substr(0, letters), number = name.substr(letters);
  const bool isNumber = !number.empty() && number.find_first_not_of("0123456789") == number.npos;
  const bool isNumbered =
      isNumber && (head == "v" || head == "z" || head == "tool" || head == "wobj" || head == "load");
  return isNumbered || name == "fine" || name == "vmax";
}

std::string plainFrameName(const RobotProgram& program) {
  return frameIdentifier(program, kRapidWords, kLongestShared);
}

// With a number, where another frame is called so.
std::string prefixedFrameName(const RobotProgram& program) {
  const std::string wish = kFramePrefix + plainFrameName(program);
  std::string name = wish;
  const auto isSame = [&](const std::string& other) {
    return lowerCase(identifierOf(other, kLongestShared)) == lowerCase(name);
  };
  for (int n = 2; std::ranges::any_of(program.otherFrames, isSame); ++n) name = wish + "_" + std::to_string(n);
  return name;
}

}  // namespace

std::string rapidName(const std::string& path) {
  return identifierBeside(kRapidWords, path, kLongestShared);
}

std::string rapidFrameName(const RobotProgram& program) {
  if (program.frameName.empty()) return rapidName(program.name) + "_frame";
  const std::string name = plainFrameName(program), lower = lowerCase(name);
  const auto isOfPath = [&](const std::string& path) {
    const std::string own = lowerCase(rapidName(path));
    return lower == own || lower.starts_with(own + "_");
  };
  const bool isTaken = isOfPath(program.name) || std::ranges::any_of(program.otherPaths, isOfPath) ||
                       lower.starts_with("p_") || isStandardData(lower);
  return isTaken ? prefixedFrameName(program) : name;
}

std::vector<std::string> rapidFrameNames(const RobotProgram& program) {
  return {plainFrameName(program), prefixedFrameName(program)};
}

}  // namespace handwheel
