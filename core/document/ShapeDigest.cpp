// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/ShapeDigest.h"

#include <QCryptographicHash>
#include <span>

namespace handwheel {

std::string shapeDigest(const TriangleSoup& shape) {
  QCryptographicHash hash(QCryptographicHash::Sha256);
  const auto add = [&hash](std::span<const std::byte> bytes) {
    hash.addData(
        QByteArray::fromRawData(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size())));
  };
  add(std::as_bytes(std::span(shape.points)));
  add(std::as_bytes(std::span(shape.triangles)));
  return hash.result().toHex().toStdString();
}

}  // namespace handwheel
