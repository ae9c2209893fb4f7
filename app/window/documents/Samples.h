// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QFileInfo;

namespace handwheel {

// Returns the path of a sample shipped with the program. The result is empty if the sample is missing.
QString samplePath(const QString& name);

// Returns true if the file is a sample shipped with the program.
bool isSample(const QFileInfo& file);

}  // namespace handwheel
