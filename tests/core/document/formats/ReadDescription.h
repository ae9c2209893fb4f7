// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <algorithm>
#include <bit>
#include <cstring>

// The result of a reader as one line of text, which tests compare.
namespace handwheel::test {

inline const char* nameOf(LostAttribute lost) {
  constexpr const char* kNames[] = {"Colour", "Normals", "TextureCoordinates", "Materials", "Groups", "Lines",
                                    "Points", "Curves",  "ExactSurfaces",      "Other"};
  return kNames[static_cast<std::size_t>(lost)];
}

// Returns a text such as "NumberMalformed(1X) line 15".
inline QString describe(const Error& error) {
  QStringList arguments;
  for (const std::string& argument : error.arguments) arguments << QString::fromLatin1(argument.c_str());
  QString text = error.code->id;
  if (!arguments.isEmpty()) text += "(" + arguments.join(",") + ")";
  if (error.position.kind == InputPosition::Kind::Byte) text += QString(" byte %1").arg(error.position.value);
  if (error.position.kind == InputPosition::Kind::Line) text += QString(" line %1").arg(error.position.value);
  return text;
}

// Returns a text such as "0 0 0, 1 0 0, 0 1 0 | 0 1 2" or "... ! damage; damage - Colour Normals".
inline QString describe(const Result<MeshFile>& result) {
  if (!result) return describe(result.error());
  QStringList points, triangles, damage;
  for (const Vec3& p : result->soup.points)
    points << QString("%1 %2 %3").arg(p.x(), 0, 'g', 9).arg(p.y(), 0, 'g', 9).arg(p.z(), 0, 'g', 9);
  for (const Triangle& t : result->soup.triangles) triangles << QString("%1 %2 %3").arg(t[0]).arg(t[1]).arg(t[2]);
  for (const Error& error : result->damage) damage << describe(error);
  QString text = points.join(", ") + " | " + triangles.join(", ");
  if (!damage.isEmpty()) text += " ! " + damage.join("; ");
  if (!result->lost.empty()) text += " -";
  for (LostAttribute lost : result->lost) text += QString(" ") + nameOf(lost);
  return text;
}

inline Result<MeshFile> read(const QByteArray& bytes, bool partial = false, const char* name = "") {
  return readMesh({bytes.constData(), static_cast<std::size_t>(bytes.size())}, name, {partial});
}

// Bytes that contain numbers in a given byte order.
class Bytes {
 public:
  explicit Bytes(std::endian order = std::endian::little) : m_order(order) {}

  template <class T>
  Bytes& add(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (m_order != std::endian::native) std::reverse(raw, raw + sizeof(T));
    m_bytes.append(raw, sizeof(T));
    return *this;
  }
  Bytes& text(const QByteArray& characters) {
    m_bytes += characters;
    return *this;
  }
  template <class T>
  Bytes& all(std::initializer_list<T> values) {
    for (T value : values) add(value);
    return *this;
  }
  operator QByteArray() const { return m_bytes; }

 private:
  std::endian m_order;
  QByteArray m_bytes;
};

// The description of the triangle that most inputs contain.
inline const QString kTriangle = "0 0 0, 1 0 0, 0 1 0 | 0 1 2";

}  // namespace handwheel::test
