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
inline constexpr int kExitInterrupted = 130;  // as shells report a program that SIGINT ended

// One line on stderr, with the program's name before it.
void complain(std::string_view sentence);

// Says what went wrong and what to do about it, on one line. Returns the exit code for it.
int fail(const Error& error);

// Says that there is not enough memory for a file, however little is left. Returns kExitError.
int failForMemory(const std::string& subject);

// Says why something is not done. Returns kExitError.
int refuse(std::string_view sentence);

// Says it, and where help is to be had. Returns kExitError.
int failUsage(std::string_view sentence, std::string_view command);

// What went wrong, as one sentence.
std::string sentenceFor(const Error& error);

// The same and what to do about it.
std::string fullSentenceFor(const Error& error);

// Writes to stdout; kExitError when it does not take all (a full disk, say).
int print(std::string_view text);

}  // namespace handwheel
