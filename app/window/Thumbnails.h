// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPixmap>

class QImage;
class QThreadPool;

namespace handwheel {

// Small pictures of files, in the cache of the program; by path, so they may be older than the file.
class Thumbnails : public QObject {
  Q_OBJECT

 public:
  explicit Thumbnails(QThreadPool& pool, QObject* parent = nullptr) : QObject(parent), m_pool(pool) {}

  static QImage pictureOf(const QImage& view);             // the middle of a view, small
  void store(const QString& path, const QImage& picture);  // a small one, on a worker
  static QPixmap of(const QString& path);                  // a null one where there is none

 signals:
  void stored();

 private:
  QThreadPool& m_pool;
};

}  // namespace handwheel
