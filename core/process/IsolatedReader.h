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
  // Bytes of address space; 0: no limit, because a sanitizer uses terabytes of address space.
  std::uint64_t memory = memoryForReader();
  std::chrono::seconds cpu{60};
  std::chrono::seconds wall = 2 * cpu;            // from start to end, including waits for a processor
  std::size_t mostOutput = std::size_t{1} << 30;  // bytes

  // Returns half of the memory that the system has available, but at least the memory for reading an empty file.
  // Returns 0, no limit, if the program is built with a sanitizer.
  static std::uint64_t memoryForReader();
};

// A program that reads files in a separate process. It is for a library whose parser is not safe against hostile files.
struct IsolatedReader {
  std::string program;  // path of the program, see readerProgram()
  std::string library;  // name of the library that parses, for errors: "Open CASCADE"
  ReaderLimits limits;
};

// Returns the path of a reader program of Handwheel. The program is in the folder "readers" beside this library, or in
// the folder HANDWHEEL_READERS.
std::string readerProgram(const std::string& name);

// Reads a file in a separate process, and returns the answer of the process, which may be arbitrary bytes and must be
// treated like a file. The process gets the bytes of the file and the options; Handwheel gives it no other files. The
// process has always ended when the function returns. The function blocks, and may be called on any thread. Cancelling
// kills the process. Errors: LibraryFailed {library, reason} if the reader reports a reason, crashes, exceeds a limit,
// or answers nothing or too much; OutOfMemory; Cancelled.
Result<std::string> readIsolated(const IsolatedReader& reader, const std::vector<std::string>& options,
                                 std::string_view bytes, Progress progress = {});

}  // namespace handwheel
