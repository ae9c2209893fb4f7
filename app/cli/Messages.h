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
inline constexpr int kExitSomethingLeft = 2;  // done, but something is left to do, such as an open hole
inline constexpr int kExitInterrupted = 130;  // the code that shells use for a program ended by SIGINT

// Prints a sentence as one line on stderr, prefixed with the program's name.
void complain(std::string_view sentence);

// Reports an error and its remedy on one line of stderr. Returns the exit code for the error.
int fail(const Error& error);

// Reports that there is not enough memory for a file. Works with very little memory left. Returns kExitError.
int failForMemory(const std::string& subject);

// Reports the reason why a request is refused. Returns kExitError.
int refuse(std::string_view sentence);

// Reports a usage error and the command that prints the help. Returns kExitError.
int failUsage(std::string_view sentence, std::string_view command);

// Describes an error in one sentence.
std::string sentenceFor(const Error& error);

// Describes an error and its remedy.
std::string fullSentenceFor(const Error& error);

// Writes text to stdout. Returns kExitError if part of the text could not be written, as on a full disk.
int print(std::string_view text);

}  // namespace handwheel
