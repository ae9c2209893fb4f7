// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "mesh/Defects.h"
#include "mesh/MeshDelta.h"

namespace handwheel {

// Any change of a document's mesh, held as the slots that differ, and the defects of the version that is not present.
class MeshEdit : public Edit {
 public:
  MeshEdit(MeshDelta delta, std::shared_ptr<const Defects> defects)
      : m_delta(std::move(delta)), m_defects(std::move(defects)) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override { return sizeof *this + m_delta.bytes(); }

 private:
  MeshDelta m_delta;
  std::shared_ptr<const Defects> m_defects;
};

}  // namespace handwheel
