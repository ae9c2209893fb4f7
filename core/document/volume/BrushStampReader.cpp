// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/BrushStampReader.h"

#include "document/DisplayModel.h"
#include "document/FileBytes.h"
#include "volume/VolumeErrors.h"

#include <QBuffer>
#include <QImage>
#include <QImageReader>
#include <QPainter>
#include <algorithm>
#include <array>

namespace handwheel {
namespace {

// Returns the format of a picture that can be read here; empty: none. Formats with scripts, and those whose readers are
// not safe for untrusted input, are excluded.
QByteArray pictureFormat(std::string_view head) {
  static const std::array<QByteArray, 8> kFormats = {"png", "jpeg", "jpg", "bmp", "gif", "pgm", "ppm", "pbm"};
  QByteArray bytes = QByteArray::fromRawData(head.data(), static_cast<qsizetype>(head.size()));
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::ReadOnly);
  const QByteArray format = QImageReader::imageFormat(&buffer);
  return std::find(kFormats.begin(), kFormats.end(), format) != kFormats.end() ? format : QByteArray();
}

std::shared_ptr<const ClayStamp> stampOfPicture(const QImage& picture) {
  QImage grey(picture.size(), QImage::Format_RGB32);
  grey.fill(Qt::black);
  QPainter(&grey).drawImage(0, 0, picture);
  grey = grey.convertToFormat(QImage::Format_Grayscale16);
  std::vector<float> heights;
  heights.reserve(static_cast<std::size_t>(grey.width()) * static_cast<std::size_t>(grey.height()));
  bool isAny = false;
  for (int row = 0; row < grey.height(); ++row) {
    const auto* const line = reinterpret_cast<const quint16*>(grey.constScanLine(row));
    for (int column = 0; column < grey.width(); ++column) {
      heights.push_back(static_cast<float>(line[column]) / 65535.0f);
      isAny = isAny || line[column] > 0;
    }
  }
  return isAny ? std::make_shared<const ClayStamp>(grey.width(), grey.height(), std::move(heights)) : nullptr;
}

// Errors are without subject.
Result<std::shared_ptr<const ClayStamp>> readPicture(const std::filesystem::path& path, const QByteArray& format,
                                                     Progress progress) {
  std::error_code failed;
  const auto size = static_cast<std::size_t>(std::filesystem::file_size(path, failed));
  if (failed) return Error{ErrorCode::FileUnreadable, {failed.message()}, {}, {}};
  if (size > kMostStampBytes)
    return Error{
        ErrorCode::FileTooLarge, {"bytes of a picture", std::to_string(size), std::to_string(kMostStampBytes)}, {}, {}};
  const Result<std::string> content = readFileBytes(path, progress.part(0.0, 0.5));
  if (!content) return content.error();
  QByteArray bytes = QByteArray::fromRawData(content->data(), static_cast<qsizetype>(content->size()));
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::ReadOnly);
  QImageReader reader(&buffer, format);
  reader.setAutoDetectImageFormat(false);
  reader.setAutoTransform(true);
  const QSize whole = reader.size();
  if (whole.isEmpty()) return Error{VolumeErrors::PictureUnreadable, {format.toStdString()}, {}, {}};
  const auto pixels = static_cast<std::size_t>(whole.width()) * static_cast<std::size_t>(whole.height());
  if (pixels > kMostStampPixels)
    return Error{ErrorCode::FileTooLarge,
                 {"pixels of a picture", std::to_string(pixels), std::to_string(kMostStampPixels)},
                 {},
                 {}};
  const QSize most(ClayStamp::kMostSide, ClayStamp::kMostSide);
  if (whole.width() > most.width() || whole.height() > most.height())
    reader.setScaledSize(whole.scaled(most, Qt::KeepAspectRatio).expandedTo({1, 1}));
  const QImage picture = reader.read();
  if (picture.isNull()) return Error{VolumeErrors::PictureUnreadable, {format.toStdString()}, {}, {}};
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  auto stamp = stampOfPicture(picture);
  if (!stamp) return Error{VolumeErrors::NothingStandsOut, {}, {}, {}};
  return stamp;
}

}  // namespace

Result<std::shared_ptr<const ClayStamp>> readBrushStamp(const std::filesystem::path& path, const DocumentKinds& kinds,
                                                        Progress progress) {
  const auto about = [&](Error error) {
    if (error.subject.empty()) error.subject = path.string();
    return error;
  };
  const Result<std::string> head = readFileHead(path);
  if (!head) return about(head.error());
  if (const QByteArray format = pictureFormat(*head); !format.isEmpty()) {
    auto stamp = readPicture(path, format, progress);
    return stamp ? stamp : about(stamp.error());
  }
  const Result<OpenedFile> opened = kinds.open(path, {}, progress.part(0.0, 0.6));
  if (!opened) return opened.error();
  auto stamp = stampOfSurface(placedSoup(opened->kind->display(*opened->content)), progress.part(0.6, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (!stamp) return about(Error{VolumeErrors::NothingStandsOut, {}, {}, {}});
  return stamp;
}

}  // namespace handwheel
