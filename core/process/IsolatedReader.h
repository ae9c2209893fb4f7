// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// Limits of a process that reads one file.
struct ReaderLimits {
  // Bytes of address space; unlimited where a sanitizer takes them by the terabyte.
  std::uint64_t memory = memoryForReader();
  std::chrono::seconds cpu{60};
  std::chrono::seconds wall = 2 * cpu;            // from start to end: a reader may also wait for the machine
  std::size_t mostOutput = std::size_t{1} << 30;  // bytes

  // Returns half of the memory that the system has left, and at least what reading an empty file takes.
  static std::uint64_t memoryForReader();
};

// A program that reads files in a process of its own. For a library whose parser is not proof against hostile files.
struct IsolatedReader {
  std::string program;  // its path, see readerProgram()
  std::string library;  // the library that parses, for errors: "Open CASCADE"
  ReaderLimits limits;
};

// Returns the path of a reader program of ours: in the folder "readers" beside this library, or in that of
// HANDWHEEL_READERS.
std::string readerProgram(const std::string& name);

// Reads a file in a process of its own, and returns its answer, which may be anything: bytes to be judged like a file.
// The process gets these bytes and options, and nothing else of the file system by us; it is gone afterwards in any
// case. Blocks; any thread. Cancelling kills it. Errors: LibraryFailed {library, reason} with the reader's own reason,
// or if it crashes, exceeds a limit, answers nothing or too much; OutOfMemory; Cancelled.
Result<std::string> readIsolated(const IsolatedReader& reader, const std::vector<std::string>& options,
                                 std::string_view bytes, Progress progress = {});

}  // namespace handwheel
