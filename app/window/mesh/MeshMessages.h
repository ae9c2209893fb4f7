// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/MessageBar.h"

#include <optional>

namespace handwheel {

class MeshDocument;

// Messages about a mesh, translated; each is over when it is no longer true. The document outlives them.

// A change did nothing: what was wanted, and why.
Message nothingChangedMessage(const MeshDocument& document, const QString& what, const QString& why);
// A change had its effect on some of the sheets only.
Message partlyChangedMessage(const MeshDocument& document, const QString& what, const QString& how);
// The size of a mesh that was just opened is unlikely in mm; none where it is not. Its action is to be added.
std::optional<Message> unitDoubtMessage(const MeshDocument& document);

}  // namespace handwheel
