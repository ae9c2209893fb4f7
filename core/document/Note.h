// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/defects/MeshState.h"

#include <string>
#include <vector>

namespace handwheel {

// A message to the user about the result of an operation. The text is an English sentence with %1, %2… for the
// arguments; it is translated for display (context "Note"; widgets/text/NoteText.h).
struct Note {
  std::string text;
  std::vector<std::string> arguments = {};
  bool isLoss = false;                  // the file lacks some content of the document
  std::optional<MeshState> state = {};  // replaces %1, in the words of stateText()
};

}  // namespace handwheel
