// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace handwheel {

class DocumentKinds;

// One input file of a batch repair and its output.
struct BatchFile {
  std::filesystem::path input;
  std::filesystem::path output;
  std::string problem;  // the reason why the file or folder cannot be read, as a sentence; empty: no problem
};

// The input files of a batch repair and their output paths.
struct BatchPlan {
  std::vector<BatchFile> files;                // in the order of the operands; the files of a folder are sorted by path
  std::set<std::pair<dev_t, ino_t>> inputIds;  // device and inode numbers of the inputs that exist
  std::string problem;                         // the reason why there is no plan, as a sentence; empty: there is one

  // Returns true if the path is one of the inputs, under any name or link.
  bool isInput(const std::filesystem::path& path) const;
};

// Determines the input and output files of a batch repair. An operand is a file or a folder. A folder means all files
// in it that have the extension of a mesh format; hidden files, linked folders and the output folder are skipped. The
// files of a folder are written to the same relative paths below the output folder, a single file directly into the
// output folder. "ending" (without dot) replaces the extension unless it is empty. A file that is named twice is
// repaired once. There is no plan if two files would have the same output, if an output is an input, or if there are
// more than a million files. A signal ends the search early.
BatchPlan planBatch(const std::vector<std::string>& operands, const std::filesystem::path& output,
                    std::string_view ending, const DocumentKinds& kinds);

}  // namespace handwheel
