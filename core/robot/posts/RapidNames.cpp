// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/RapidNames.h"

#include "robot/posts/PostText.h"

#include <algorithm>
#include <array>

namespace handwheel {

namespace {

constexpr std::size_t kLongestRapidSuffix = 7;  // "_module"
constexpr std::size_t kLongestShared = kLongestRapidName - kLongestRapidSuffix;
constexpr const char* kFramePrefix = "wobj_";
constexpr const char* kModuleEndings[] = {"", "_module", "_tool",
                                          "_frame"};  // suffixes of the path's name in its module
// Words of the language, its data types, routines of every controller, and the procedure that a task begins with.
constexpr const char* kRapidWords[] = {
    "abs",       "accset",   "add",        "alias",       "and",      "backward",  "bitand",   "bool",
    "break",     "byte",     "calcjointt", "calcrobt",    "case",     "cjointt",   "clear",    "clkread",
    "clkreset",  "clkstart", "clkstop",    "clock",       "confdata", "confj",     "confl",    "connect",
    "const",     "cos",      "cpos",       "crobt",       "ctool",    "cwobj",     "decr",     "default",
    "div",       "dnum",     "do",         "else",        "elseif",   "endfor",    "endfunc",  "endif",
    "endmodule", "endproc",  "endrecord",  "endtest",     "endtrap",  "endwhile",  "error",    "exit",
    "extjoint",  "false",    "for",        "from",        "func",     "goto",      "gripload", "if",
    "incr",      "inout",    "invertdo",   "jointtarget", "loaddata", "local",     "main",     "mod",
    "module",    "moveabsj", "movec",      "movej",       "movel",    "nostepin",  "not",      "noview",
    "num",       "offs",     "or",         "orient",      "pers",     "pi",        "pos",      "pose",
    "proc",      "pulsedo",  "raise",      "readonly",    "record",   "reltool",   "reset",    "retry",
    "return",    "robjoint", "robtarget",  "round",       "searchc",  "searchj",   "searchl",  "set",
    "setao",     "setdo",    "setgo",      "sin",         "singarea", "speeddata", "sqrt",     "step",
    "stop",      "string",   "switch",     "sysmodule",   "tan",      "test",      "then",     "to",
    "tooldata",  "tperase",  "tpwrite",    "trap",        "triggc",   "triggj",    "triggl",   "true",
    "trunc",     "trynext",  "undo",       "var",         "velset",   "viewonly",  "waitdi",   "waitdo",
    "waitrob",   "waittime", "waituntil",  "while",       "with",     "wobjdata",  "xor",      "zonedata"};

// Returns true for data of every controller: no path or frame may hide them.
bool isStandardData(const std::string& name) {
  const std::size_t letters = std::min(name.find_first_of("0123456789"), name.size());
  const std::string head = name.substr(0, letters), number = name.substr(letters);
  const bool isNumber = !number.empty() && number.find_first_not_of("0123456789") == number.npos;
  const bool isNumbered =
      isNumber && (head == "v" || head == "z" || head == "tool" || head == "wobj" || head == "load");
  return isNumbered || name == "fine" || name == "vmax";
}

// Returns the name of a path, independently of others.
std::string nameOfPath(const std::string& path) {
  const std::string name = identifierBeside(kRapidWords, path, kLongestShared);
  return isStandardData(lowerCase(name)) ? identifierOf(name + "_path", kLongestShared) : name;
}

std::string plainFrameName(const RobotProgram& program) {
  return frameIdentifier(program, kRapidWords, kLongestShared);
}

// Returns the name, with a number if another frame has the same.
std::string prefixedFrameName(const RobotProgram& program) {
  const std::string preferred = kFramePrefix + plainFrameName(program);
  std::string name = preferred;
  const auto isSame = [&](const std::string& other) {
    return lowerCase(identifierOf(other, kLongestShared)) == lowerCase(name);
  };
  const std::set<std::string> kept = keptNames(program, "rapid");
  const auto isTaken = [&] {
    return kept.contains(lowerCase(name)) || std::ranges::any_of(program.otherFrames, isSame);
  };
  for (int n = 2; isTaken(); ++n) name = preferred + "_" + std::to_string(n);
  return name;
}

}  // namespace

std::string rapidName(const RobotProgram& program) {
  const std::string made = nameOfPath(program.name), lower = lowerCase(made);
  // The suffixes of modules may turn the name of a path into that of another one, too.
  const auto meets = [&](const std::string& path) {
    const std::string other = lowerCase(nameOfPath(path));
    return path != program.name && std::ranges::any_of(kModuleEndings, [&](const char* ending) {
             return lower == other + ending || other == lower + ending;
           });
  };
  // Kept lines may declare or use any name.
  const std::set<std::string> kept = keptNames(program, "rapid");
  const auto isKept = [&](const std::string& name) {
    return std::ranges::any_of(kept, [own = lowerCase(name)](const std::string& each) {
      if (!each.starts_with(own)) return false;
      const std::string ending = each.substr(own.size());
      const bool isPart = ending.starts_with('_') && ending.find_first_not_of("0123456789", 1) == ending.npos;
      return isPart || std::ranges::find(kModuleEndings, ending) != std::end(kModuleEndings);
    });
  };
  if (!std::ranges::any_of(program.otherPaths, meets) && !isKept(made)) return made;
  std::string name = identifierWithDigits(program.name, kLongestShared);
  for (int n = 2; isKept(name); ++n)
    name = identifierWithDigits(program.name + "_" + std::to_string(n), kLongestShared);
  return name;
}

std::string rapidFrameName(const RobotProgram& program) {
  if (program.frameName.empty()) return rapidName(program) + "_frame";
  const std::string name = plainFrameName(program), lower = lowerCase(name);
  const auto isOfPath = [&](const std::string& path) {
    return std::ranges::any_of(std::array{nameOfPath(path), identifierWithDigits(path, kLongestShared)},
                               [&](const std::string& each) {
                                 const std::string own = lowerCase(each);
                                 return lower == own || lower.starts_with(own + "_");
                               });
  };
  const bool isTaken = keptNames(program, "rapid").contains(lower) || isOfPath(program.name) ||
                       std::ranges::any_of(program.otherPaths, isOfPath) || lower.starts_with("p_") ||
                       isStandardData(lower);
  return isTaken ? prefixedFrameName(program) : name;
}

std::vector<std::string> rapidFrameNames(const RobotProgram& program) {
  return {plainFrameName(program), prefixedFrameName(program)};
}

}  // namespace handwheel
