// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"

#include <QStringList>
#include <optional>

namespace handwheel {

QString containerEnding();  // ".handwheel"

// The foreign format of the kind that the ending of the path names; none for a container.
std::optional<FileFormat> formatOf(const DocumentKind& kind, const QString& path);
// Whether documents of the kind can be written to such a path.
bool canWrite(const DocumentKind& kind, const QString& path);

// The drawing for a file, by the kind that reads such an ending, or else writes it.
QString iconNameFor(const DocumentKinds& kinds, const QString& path);

// What a file dialog offers: all that is opened, then one line for each kind.
QStringList openFilters(const DocumentKinds& kinds);
// All formats of the kind, then one line for each.
QStringList saveFilters(const DocumentKind& kind);

}  // namespace handwheel
