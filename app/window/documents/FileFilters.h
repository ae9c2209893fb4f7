// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"

#include <QStringList>
#include <optional>

namespace handwheel {

// Returns the extension of the native file format.
QString containerEnding();  // ".handwheel"

// Returns the format of the kind that has the path's extension. The result is empty if there is none, as for the native
// file format.
std::optional<FileFormat> formatOf(const DocumentKind& kind, const QString& path);
// Returns the extension of a path. If the path has the extension of a format of the kind, which may contain dots,
// returns that extension; otherwise the part after the last dot.
QString endingOf(const DocumentKind& kind, const QString& path);
// Returns true if documents of the kind can be written in the format of the path.
bool canWrite(const DocumentKind& kind, const QString& path);

// Returns the icon name for a file. It is the icon of the kind that can read its extension, or else of one that can
// write it.
QString iconNameFor(const DocumentKinds& kinds, const QString& path);

// Returns the name filters of the open dialog: one for all readable files, then one for each kind. beside: further
// filters, for files that are opened beside a document (CompanionFiles).
QStringList openFilters(const DocumentKinds& kinds, const QStringList& beside = {});
// Returns the name filters of the save dialog: one for all formats of the kind, then one for each format.
QStringList saveFilters(const DocumentKind& kind);
// Returns a file name with the ending of a filter for one format, in place of its own; unchanged if it has one of the
// filter's endings already.
QString renamedFor(const DocumentKind& kind, const QString& name, const QString& filter);

}  // namespace handwheel
