// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "cli/mesh/batch/BatchFiles.h"
#include "process/ChildProcess.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// After this a child that was asked to end is killed. Programs of ours end by themselves within 250 ms, or are ended.
inline constexpr std::chrono::milliseconds kChildGrace{225};

// The options that the result for each of several files depends on, as command line words in an order of their own.
std::vector<std::string> repairOptions(const Arguments& arguments);

// Parses --time-limit. Returns the error as a sentence, or nothing. seconds: stays as it is without the option.
std::string readTimeLimit(const Arguments& arguments, std::optional<double>& seconds);
// Parses --format, the ending of the output files. Returns the error as a sentence, or nothing.
std::string checkFormat(const Arguments& arguments);

// A child process that repairs one file of several.
struct StartedRepair {
  std::unique_ptr<ChildProcess> child;  // null where it cannot be started
  std::string problem;                  // why not, as a sentence
};
// Starts it; the folder of the output is made. It prints JSON.
StartedRepair startRepair(const BatchFile& file, const std::vector<std::string>& options);

// The sentences that it complained with.
std::vector<std::string> complaintsOf(const ChildProcess& child);
// Why it has no result, as a sentence.
std::string failureOf(const ChildProcess& child, const BatchFile& file);
// The same where it was ended after this time.
std::string tooLong(double seconds);

}  // namespace handwheel
