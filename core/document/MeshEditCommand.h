// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/Defects.h"
#include "mesh/MeshDelta.h"

#include <QUndoCommand>

namespace handwheel {

class MeshDocument;

// One step in a document's history: any change of its mesh, held as the slots that differ, and the defects of the
// version that is not present. Undo and redo are the same exchange, because swapping a delta leaves its inverse.
class MeshEditCommand : public QUndoCommand {
 public:
  MeshEditCommand(MeshDocument& document, const QString& text, MeshDelta delta, std::shared_ptr<const Defects> defects);

  void redo() override { exchange(); }
  void undo() override { exchange(); }

 private:
  void exchange();

  MeshDocument& m_document;
  MeshDelta m_delta;
  std::shared_ptr<const Defects> m_defects;
};

}  // namespace handwheel
