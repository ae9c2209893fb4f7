// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "panels/MessageBar.h"

#include <functional>
#include <optional>

namespace handwheel {

class Document;
class MeshDocument;

// Messages about a mesh, translated; each is over when it is no longer true. The document outlives them.

// A change did nothing: what was wanted, and why.
Message nothingChangedMessage(const MeshDocument& document, const QString& what, const QString& why);
// A change had its effect on some of the sheets only.
Message partlyChangedMessage(const MeshDocument& document, const QString& what, const QString& how);
// What a change did, until the next one. how: a list of phrases.
Message changeMessage(const MeshDocument& document, const QString& text, const QString& how);
// A change took something away from the outside. warning: removalWarning().
Message partRemovedMessage(const MeshDocument& document, const QString& what, const QString& warning,
                           std::function<void()> undo);
// A deletion left nothing of some connected pieces.
Message piecesDeletedMessage(const MeshDocument& document, std::size_t pieces, std::size_t faces,
                             std::function<void()> undo);
// A mesh cannot be drilled. why: a phrase. makeVolume: makes a volume of it, which can.
Message notDrilledMessage(const MeshDocument& document, const QString& why, std::function<void()> makeVolume);
// A job failed; nothing was changed. job: its name.
Message jobFailedMessage(const Document& document, const QString& job, const Error& error);
// The size of a mesh that was just opened is unlikely in mm; none where it is not. Its action is to be added.
std::optional<Message> implausibleUnitMessage(const MeshDocument& document);

}  // namespace handwheel
