// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/mesh/MeshEdit.h"

namespace handwheel {

// The reversal of faces when a file is opened. It is the first step of the history of a mesh from a foreign file.
// Undoing it restores the directions that the faces have in the file.
class ReversalEdit : public MeshEdit {
 public:
  using MeshEdit::MeshEdit;

  void exchange(Document& document) override;
};

}  // namespace handwheel
