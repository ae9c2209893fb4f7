// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"

#include <QStringList>
#include <optional>

namespace handwheel {

// The extension of the native file format.
QString containerEnding();  // ".handwheel"

// The foreign format of the kind by the path's extension; none for a container.
std::optional<FileFormat> formatOf(const DocumentKind& kind, const QString& path);
// The ending of a path with its dots, as the formats of the kind have it; of other paths what follows the last dot.
QString endingOf(const DocumentKind& kind, const QString& path);
// Whether documents of the kind can be written in the format of the path.
bool canWrite(const DocumentKind& kind, const QString& path);

// The icon name for a file. It is that of the kind that reads, or else writes, its extension.
QString iconNameFor(const DocumentKinds& kinds, const QString& path);

// The name filters of the open dialog: all readable files, then one per kind.
QStringList openFilters(const DocumentKinds& kinds, const QStringList& beside = {});
// The name filters of the save dialog: all formats of the kind, then each.
QStringList saveFilters(const DocumentKind& kind);

}  // namespace handwheel
