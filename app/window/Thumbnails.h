// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>
#include <QString>

class QImage;
class QThreadPool;

namespace handwheel {

// Small pictures of files, in the cache of the program; by path, so they may be older than the file.
// Stores on a worker.
void storeThumbnail(const QString& path, const QImage& picture, QThreadPool& pool);
// A null one where there is none.
QPixmap thumbnailOf(const QString& path);

}  // namespace handwheel
