// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/batch/ChildRepair.h"

#include "base/NumberText.h"
#include "cli/Messages.h"
#include "cli/SupervisedChild.h"
#include "cli/mesh/MeshOutput.h"
#include "document/DocumentKind.h"
#include "document/formats/MeshExport.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace handwheel {

namespace {

constexpr double kLongestLimit = 1e6;  // seconds
constexpr std::string_view kName = "handwheel: ";

bool isEndingOfMesh(const std::string& ending) {
  return formatForOutput("x." + ending) || isContainerName("x." + ending);
}

}  // namespace

std::vector<std::string> repairOptions(const Arguments& arguments) {
  static constexpr std::array<std::string_view, 7> kNotOfTheRepair{"jobs",   "format", "resume", "time-limit",
                                                                   "output", "report", "json"};
  std::vector<std::string> words;
  for (const auto& [name, value] : arguments.options)
    if (std::find(kNotOfTheRepair.begin(), kNotOfTheRepair.end(), name) == kNotOfTheRepair.end())
      words.push_back("--" + name + (value.empty() ? "" : "=" + value));
  return words;
}

std::string readTimeLimit(const Arguments& arguments, std::optional<double>& seconds) {
  if (!arguments.has("time-limit")) return {};
  double limit = 0.0;
  if (!readNumber(arguments.valueOf("time-limit"), limit) || !(limit > 0.0 && limit <= kLongestLimit))
    return "--time-limit takes a number of seconds above zero.";
  seconds = limit;
  return {};
}

std::string checkFormat(const Arguments& arguments) {
  if (!arguments.has("format") || isEndingOfMesh(arguments.valueOf("format"))) return {};
  return "--format takes " + meshFormatWords(true) + ".";
}

StartedRepair startRepair(const BatchFile& file, const std::vector<std::string>& options) {
  if (!file.problem.empty()) return {nullptr, file.problem};
  std::error_code error;
  std::filesystem::create_directories(file.output.parent_path(), error);
  if (error) return {nullptr, "The output folder cannot be created (" + error.message() + ")."};
  std::vector<std::string> words{ownProgram(), "repair", "--json"};
  words.insert(words.end(), options.begin(), options.end());
  words.insert(words.end(), {"-o", file.output.string(), "--", file.input.string()});
  StartedRepair started{ChildProcess::start(words), {}};
  if (!started.child) started.problem = std::string("No process can be started for it (") + std::strerror(errno) + ").";
  return started;
}

std::vector<std::string> complaintsOf(const ChildProcess& child) {
  std::string_view errors = child.errors();
  std::vector<std::string> sentences;
  while (!errors.empty()) {
    const std::string_view line = errors.substr(0, errors.find('\n'));
    errors.remove_prefix(std::min(errors.size(), line.size() + 1));
    if (line.starts_with(kName)) sentences.emplace_back(line.substr(kName.size()));
  }
  return sentences;
}

std::string failureOf(const ChildProcess& child, const BatchFile& file) {
  const std::vector<std::string> sentences = complaintsOf(child);
  if (child.code() == 128 + SIGKILL) return "The system ended its process; memory may have run out.";
  if (child.code() > 128 && child.code() != kExitInterrupted)
    return std::string("Its process crashed (") + strsignal(child.code() - 128) + ").";
  if (sentences.empty())
    return "Its process ended with the code " + std::to_string(child.code()) + " without a message.";
  const std::string& last = sentences.back();
  const std::string input = file.input.string();  // stands before it on the line
  const bool hasSubject = last.starts_with(input + ": ") || last.starts_with(input + ", ");
  return hasSubject ? last.substr(input.size() + 2) : last;
}

std::string tooLong(double seconds) {
  return "It took longer than " + shortestText(seconds) + " s.";
}

}  // namespace handwheel
