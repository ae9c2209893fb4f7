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

struct BatchFile {
  std::filesystem::path input;
  std::filesystem::path output;
  std::string problem;  // why it cannot be repaired, as a sentence: a folder that cannot be listed; else empty
};

// Which files are repaired, and where the result of each goes.
struct BatchPlan {
  std::vector<BatchFile> files;                // in the order of the operands, those of a folder by their paths
  std::set<std::pair<dev_t, ino_t>> inputIds;  // of those that exist
  std::string problem;                         // why there is no such plan, as a sentence; else empty

  // Whether one of the inputs is that file, by whatever name or link.
  bool isInput(const std::filesystem::path& path) const;
};

// Operands are files, and folders for all that lies in them and has the ending of a mesh format; not what is hidden,
// not linked folders, not the output folder. A folder's files go to the same places below the output folder, a file
// straight into it; with another ending where one is given (without its point). A file named twice is taken once. No
// plan when two would go to the same place, when an output is an input, or when there are more than a million. A signal
// ends the search early.
BatchPlan planBatch(const std::vector<std::string>& operands, const std::filesystem::path& output,
                    std::string_view ending, const DocumentKinds& kinds);

}  // namespace handwheel
