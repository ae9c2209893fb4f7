// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPixmap>

class QImage;
class QThreadPool;

namespace handwheel {

// Thumbnails of files, stored in the cache folder of the program. They are stored by path, so they may be older than
// the file.
class Thumbnails : public QObject {
  Q_OBJECT

 public:
  explicit Thumbnails(QThreadPool& pool, QObject* parent = nullptr) : QObject(parent), m_pool(pool) {}

  static QImage pictureOf(const QImage& view);             // returns the middle of a view, scaled down
  void store(const QString& path, const QImage& picture);  // writes a scaled-down picture, on a worker thread
  static QPixmap of(const QString& path);                  // null: there is no thumbnail

 signals:
  void stored();

 private:
  QThreadPool& m_pool;
};

}  // namespace handwheel
