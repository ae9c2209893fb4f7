// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "machining/program/ProgramSetup.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// Returns all errors that prevent a program from running, in the order of execution. The first is the error of
// runProgram(). To find the next ones, the refused parts are left out and the program is run again; so an error may be
// caused by an earlier one. At most kMostProblems, and fewer for long programs. Empty: it runs. Any thread.
inline constexpr std::size_t kMostProblems = 100;
std::vector<Error> programProblems(std::string_view text, const ProgramSetup& setup, Progress progress = {});

// Returns the dialect that the words of a program indicate, or nothing if it could be either. Cost: linear in the text.
std::optional<ProgramDialect> recognisedDialect(std::string_view text);

}  // namespace handwheel
