// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QFileInfo;

namespace handwheel {

// The path of a sample shipped with the program; empty when it is missing.
QString samplePath(const QString& name);

// Whether the file is one of these samples.
bool isSample(const QFileInfo& file);

}  // namespace handwheel
