// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/ReversalEdit.h"

#include "document/mesh/MeshDocument.h"

namespace handwheel {

void ReversalEdit::exchange(Document& document) {
  auto& owner = static_cast<MeshDocument&>(document);
  owner.m_hasFileDirections = !owner.m_hasFileDirections;
  MeshEdit::exchange(document);
}

}  // namespace handwheel
