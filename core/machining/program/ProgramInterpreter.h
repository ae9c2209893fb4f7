// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "machining/program/ProgramSetup.h"
#include "machining/program/ToolPath.h"

#include <string_view>

namespace handwheel {

// Runs a lathe program in G-code. The dialect is LinuxCNC 2.9 or Fanuc, system A. docs/programs.md lists the words.
//
// The text is hostile input: its size, its loops and its moves are limited. Every unknown word is refused with its line
// and column. Errors: Refused, Endless, TooManyMoves, FileTooLarge, Cancelled. The cost is linear in the executed
// blocks, about a microsecond for each. May be called on any thread.
Result<ToolPath> runProgram(std::string_view text, const ProgramSetup& setup, Progress progress = {});

}  // namespace handwheel
