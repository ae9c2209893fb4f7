// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/Thumbnails.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QPointer>
#include <QStandardPaths>
#include <QThreadPool>

namespace handwheel {

namespace {

constexpr QSize kSize(320, 200);  // pixels

QString fileFor(const QString& path) {
  const QByteArray name = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1).toHex();
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/thumbnails/") +
         QString::fromLatin1(name) + QStringLiteral(".png");
}

}  // namespace

void Thumbnails::store(const QString& path, const QImage& picture) {
  m_pool.start([file = fileFor(path), picture, self = QPointer<Thumbnails>(this)] {
    const QImage filled = picture.scaled(kSize, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    QDir().mkpath(QFileInfo(file).path());
    filled.copy(QRect(QPoint((filled.width() - kSize.width()) / 2, (filled.height() - kSize.height()) / 2), kSize))
        .save(file);
    const auto tell = [self] {
      if (self) emit self->stored();
    };
    QMetaObject::invokeMethod(qApp, tell, Qt::QueuedConnection);
  });
}

QPixmap Thumbnails::of(const QString& path) {
  return QPixmap(fileFor(path));
}

}  // namespace handwheel
