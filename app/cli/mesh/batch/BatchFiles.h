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
  std::string
      problem;  // the reason why it cannot be repaired, as a sentence (a folder that cannot be listed); else empty
};

// The input files of a batch repair and their output paths.
struct BatchPlan {
  std::vector<BatchFile> files;                // in the order of the operands, those of a folder by their paths
  std::set<std::pair<dev_t, ino_t>> inputIds;  // ids of the inputs that exist
  std::string problem;                         // the reason why there is no plan, as a sentence; else empty

  // Returns true if the path is one of the inputs, under any name or link.
  bool isInput(const std::filesystem::path& path) const;
};

// Determines the input and output files of a batch repair. Operands are files, or folders for all files in them with
// the extension of a mesh format; hidden files, linked folders and the output folder are skipped. The files of a folder
// go to the same relative paths below the output folder, a single file directly into it; "ending" replaces the
// extension if it is given (without its dot). A file named twice is taken once. There is no plan if two files would
// have the same output, if an output is an input, or if there are more than a million. A signal ends the search early.
BatchPlan planBatch(const std::vector<std::string>& operands, const std::filesystem::path& output,
                    std::string_view ending, const DocumentKinds& kinds);

}  // namespace handwheel
