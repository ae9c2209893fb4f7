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

inline constexpr std::size_t kMostProblems = 100;

// Returns all errors that prevent a program from running, in the order of execution. The first is the error of
// runProgram(). To find further errors, the refused parts are left out and the program is run again; an error may
// therefore be the consequence of an earlier one. There are at most kMostProblems errors, and fewer for long programs.
// The list is empty if the program runs. May be called on any thread.
std::vector<Error> programProblems(std::string_view text, const ProgramSetup& setup, Progress progress = {});

// Returns the dialect that the words of a program indicate, or nothing if the program could be in either dialect.
// O(length of the text).
std::optional<ProgramDialect> recognisedDialect(std::string_view text);

}  // namespace handwheel
