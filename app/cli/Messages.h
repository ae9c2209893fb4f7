// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <string>
#include <string_view>

namespace handwheel {

// The exit codes of every command.
inline constexpr int kExitDone = 0;
inline constexpr int kExitError = 1;
inline constexpr int kExitSomethingLeft = 2;
inline constexpr int kExitInterrupted = 130;  // the code of shells for a program that SIGINT ended

// Prints one line on stderr, prefixed with the program's name.
void complain(std::string_view sentence);

// Reports an error and its remedy on one line. Returns the exit code for it.
int fail(const Error& error);

// Reports that there is not enough memory for a file. Works with very little memory left. Returns kExitError.
int failForMemory(const std::string& subject);

// Reports the reason why a request is refused. Returns kExitError.
int refuse(std::string_view sentence);

// Reports a usage error and the command for help. Returns kExitError.
int failUsage(std::string_view sentence, std::string_view command);

// Describes an error in one sentence.
std::string sentenceFor(const Error& error);

// Describes an error and its remedy.
std::string fullSentenceFor(const Error& error);

// Writes text to stdout. Returns kExitError if not all of it could be written (a full disk, for example).
int print(std::string_view text);

}  // namespace handwheel
