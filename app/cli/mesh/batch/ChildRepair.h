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

// Time after which a child that was asked to end is killed. A Handwheel program must end within 250 ms after it was
// asked to.
inline constexpr std::chrono::milliseconds kChildGrace{225};

// Returns the options on which the result for a file depends, as command line words in a fixed order.
std::vector<std::string> repairOptions(const Arguments& arguments);

// Parses --time-limit. Returns the error as a sentence, or an empty text. "seconds" is unchanged if the option is not
// given.
std::string readTimeLimit(const Arguments& arguments, std::optional<double>& seconds);
// Checks --format, the extension of the output files. Returns the error as a sentence, or an empty text.
std::string checkFormat(const Arguments& arguments);

// A child process that repairs one file of a batch.
struct StartedRepair {
  std::unique_ptr<ChildProcess> child;  // null: it could not be started
  std::string problem;                  // the reason why it could not be started, as a sentence
};
// Starts the repair and creates the folder of the output. The child prints JSON.
StartedRepair startRepair(const BatchFile& file, const std::vector<std::string>& options);

// Returns the error messages of the child, one sentence each.
std::vector<std::string> complaintsOf(const ChildProcess& child);
// Returns the reason why the child has no result, as a sentence.
std::string failureOf(const ChildProcess& child, const BatchFile& file);
// Returns the reason for a child that was ended because it took longer than the time limit (s).
std::string tooLong(double seconds);

}  // namespace handwheel
