// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HalfEdgeMesh.h"

#include <QUndoCommand>

namespace handwheel {

class MeshDocument;

// Marks a boundary loop as wanted open, or takes the mark back. Only pushed when that changes something.
class KeepOpenCommand : public QUndoCommand {
 public:
  KeepOpenCommand(MeshDocument& document, Vertex loopKey, bool keep);

  void redo() override { mark(m_keep); }
  void undo() override { mark(!m_keep); }

 private:
  void mark(bool keep);

  MeshDocument& m_document;
  Vertex m_loopKey;
  bool m_keep;
};

}  // namespace handwheel
