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

// Messages about a mesh, translated. Each ends when it is no longer true. The document outlives them.

// A change did nothing. what: the requested change; why: the reason.
Message nothingChangedMessage(const MeshDocument& document, const QString& what, const QString& why);
// A change had its effect on some of the sheets only.
Message partlyChangedMessage(const MeshDocument& document, const QString& what, const QString& how);
// Reports the effect of a change, until the next one. how: a list of phrases.
Message changeMessage(const MeshDocument& document, const QString& text, const QString& how);
// A change removed a part of the outside. warning: removalWarning().
Message partRemovedMessage(const MeshDocument& document, const QString& what, const QString& warning,
                           std::function<void()> undo);
// A deletion left nothing of some connected pieces.
Message piecesDeletedMessage(const MeshDocument& document, std::size_t pieces, std::size_t faces,
                             std::function<void()> undo);
// A mesh cannot be drilled. why: a phrase. makeVolume: makes a volume of it, which can be drilled.
Message notDrilledMessage(const MeshDocument& document, const QString& why, std::function<void()> makeVolume);
// A job failed; nothing was changed. job: its name.
Message jobFailedMessage(const Document& document, const QString& job, const Error& error);
// The size of a mesh that was just opened is unlikely in mm; none if it is likely. The caller adds its action.
std::optional<Message> implausibleUnitMessage(const MeshDocument& document);

}  // namespace handwheel
