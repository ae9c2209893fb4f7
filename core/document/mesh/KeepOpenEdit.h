// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// Marks a boundary loop to be kept open, or removes the mark. It is created only if the mark changes.
class KeepOpenEdit : public Edit {
 public:
  KeepOpenEdit(Vertex loopKey, bool keep) : m_loopKey(loopKey), m_keep(keep) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override { return sizeof *this; }

 private:
  Vertex m_loopKey;
  bool m_keep;
};

}  // namespace handwheel
