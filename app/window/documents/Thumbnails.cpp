// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/Thumbnails.h"

#include "document/AtomicFile.h"

#include <QBuffer>
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

constexpr QSize kPictureSize(320, 200);  // pixels

QString fileFor(const QString& path) {
  const QByteArray name = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1).toHex();
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/thumbnails/") +
         QString::fromLatin1(name) + QStringLiteral(".png");
}

}  // namespace

QImage Thumbnails::pictureOf(const QImage& view) {
  const QImage filled = view.scaled(kPictureSize, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  const QPoint corner((filled.width() - kPictureSize.width()) / 2, (filled.height() - kPictureSize.height()) / 2);
  QImage picture = filled.copy(QRect(corner, kPictureSize));
  picture.setDevicePixelRatio(1);
  return picture;
}

void Thumbnails::store(const QString& path, const QImage& picture) {
  m_pool.start([file = fileFor(path), picture, self = QPointer<Thumbnails>(this)] {
    QDir().mkpath(QFileInfo(file).path());
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "PNG");
    // Written atomically, as it may be read meanwhile. If it cannot be written, the tile shows the kind's icon.
    (void)writeFileAtomically(file.toStdString(), {buffer.data().constData(), static_cast<std::size_t>(buffer.size())});
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
