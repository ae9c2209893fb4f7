// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace handwheel {

// Reads the bytes of a file in a reader program. The last argument of an error is the reason for people, an English
// clause; OutOfMemory is an error of its own.
using ReadInReader =
    std::function<Result<std::string>(std::string_view bytes, std::span<char* const> options, Progress progress)>;

// Runs a program that readIsolated() starts; its main function. Its stdin is the file; the answer goes to stdout, the
// progress to stderr. What a library prints itself goes nowhere. Ends the program.
[[noreturn]] void runReaderProgram(int argc, char** argv, const ReadInReader& read);

}  // namespace handwheel
