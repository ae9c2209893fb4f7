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

// A function that reads the bytes of a file in a reader program. The last argument of its error must be the reason for
// the user, an English clause. OutOfMemory is reported without a reason.
using ReadInReader =
    std::function<Result<std::string>(std::string_view bytes, std::span<char* const> options, Progress progress)>;

// Runs a program that readIsolated() starts, as its main function. The file is read from stdin; the answer is written
// to stdout, and the progress to stderr. Output of libraries is discarded. The function ends the program.
[[noreturn]] void runReaderProgram(int argc, char** argv, const ReadInReader& read);

}  // namespace handwheel
