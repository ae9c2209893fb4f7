// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"

#include <QStringList>
#include <optional>

namespace handwheel {

// Returns the extension of the native file format.
QString containerEnding();  // ".handwheel"

// Returns the foreign format of the kind by the path's extension; none for a container.
std::optional<FileFormat> formatOf(const DocumentKind& kind, const QString& path);
// Returns the extension of a path with its dots, as in the formats of the kind; for other paths the part after the last
// dot.
QString endingOf(const DocumentKind& kind, const QString& path);
// Returns true if documents of the kind can be written in the format of the path.
bool canWrite(const DocumentKind& kind, const QString& path);

// Returns the icon name for a file. It is that of the kind that reads, or else writes, its extension.
QString iconNameFor(const DocumentKinds& kinds, const QString& path);

// Returns the name filters of the open dialog: all readable files, then one per kind.
QStringList openFilters(const DocumentKinds& kinds, const QStringList& beside = {});
// Returns the name filters of the save dialog: all formats of the kind, then each.
QStringList saveFilters(const DocumentKind& kind);

}  // namespace handwheel
