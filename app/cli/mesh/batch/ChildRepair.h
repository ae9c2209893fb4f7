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

// Time after which a child that was asked to end is killed. Our programs end by themselves within 250 ms, or are ended.
inline constexpr std::chrono::milliseconds kChildGrace{225};

// Returns the options on which the result for each of several files depends, as command line words in a fixed order.
std::vector<std::string> repairOptions(const Arguments& arguments);

// Parses --time-limit. Returns the error as a sentence, or nothing. seconds: unchanged without the option.
std::string readTimeLimit(const Arguments& arguments, std::optional<double>& seconds);
// Checks --format, the extension of the output files. Returns the error as a sentence, or nothing.
std::string checkFormat(const Arguments& arguments);

// A child process that repairs one file of several.
struct StartedRepair {
  std::unique_ptr<ChildProcess> child;  // null if it cannot be started
  std::string problem;                  // the reason if it cannot, as a sentence
};
// Starts the repair and makes the folder of the output. The child prints JSON.
StartedRepair startRepair(const BatchFile& file, const std::vector<std::string>& options);

// Returns the error messages of the child, one sentence each.
std::vector<std::string> complaintsOf(const ChildProcess& child);
// Returns the reason why the child has no result, as a sentence.
std::string failureOf(const ChildProcess& child, const BatchFile& file);
// Returns the reason for a child that was ended after this time.
std::string tooLong(double seconds);

}  // namespace handwheel
