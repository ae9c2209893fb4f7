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

// Functions that return messages about a mesh, translated. Each message is removed when it is no longer true. The
// document must outlive the messages.

// Reports that a change did nothing. what: the requested change; why: the reason.
Message nothingChangedMessage(const MeshDocument& document, const QString& what, const QString& why);
// Reports that a change had an effect on only some of the sheets. what: the requested change; how: the affected sheets,
// and the reason for the others.
Message partlyChangedMessage(const MeshDocument& document, const QString& what, const QString& how);
// Reports the effect of a change, until the next change. how: a list of phrases.
Message changeMessage(const MeshDocument& document, const QString& text, const QString& how);
// Reports that a change removed a part of the outer surface. warning: the result of removalWarning(). undo: the
// function that undoes the change.
Message partRemovedMessage(const MeshDocument& document, const QString& what, const QString& warning,
                           std::function<void()> undo);
// Reports that a deletion removed some connected pieces completely.
Message piecesDeletedMessage(const MeshDocument& document, std::size_t pieces, std::size_t faces,
                             std::function<void()> undo);
// Reports that a mesh cannot be drilled. why: a phrase. makeVolume: the function that makes a volume from the mesh,
// which can be drilled.
Message notDrilledMessage(const MeshDocument& document, const QString& why, std::function<void()> makeVolume);
// Reports that a job failed and nothing was changed. job: the name of the job.
Message jobFailedMessage(const Document& document, const QString& job, const Error& error);
// Reports that the size of a mesh that was just opened is unlikely in mm. Returns nothing if the size is likely. The
// caller adds the action to the message.
std::optional<Message> implausibleUnitMessage(const MeshDocument& document);

}  // namespace handwheel
