// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QFileInfo;

namespace handwheel {

// Returns the path of a sample shipped with the program; empty if it is missing.
QString samplePath(const QString& name);

// Returns true if the file is one of these samples.
bool isSample(const QFileInfo& file);

}  // namespace handwheel
