// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/mesh/DefectsDelta.h"
#include "mesh/structure/MeshDelta.h"

namespace handwheel {

// Edit of a mesh, stored as the differences of slots and defects.
class MeshEdit : public Edit {
 public:
  MeshEdit(MeshDelta delta, DefectsDelta defects) : m_delta(std::move(delta)), m_defects(std::move(defects)) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override { return sizeof *this + m_delta.bytes() + m_defects.bytes(); }

 private:
  MeshDelta m_delta;
  DefectsDelta m_defects;
};

}  // namespace handwheel
