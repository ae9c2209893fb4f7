// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"
#include "document/formats/ThreeMfModel.h"

#include <QString>

// The words of 3MF's model parts that are not names of elements.
namespace handwheel::threemf {

inline const QString kCore = QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/core/2015/02");
inline const QString kProduction = QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/production/2015/06");
inline const QString kMaterials = QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/material/2015/02");
inline const QString kTriangleSets =
    QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07");

// 0 for a unit that the format does not know.
double millimetresPerUnit(QStringView unit);

// What is lost of an element that is not read.
LostAttribute lostWith(QStringView nameSpace, QStringView name);

// "m00 m01 m02 m10 … m32": a matrix of four rows and three columns that stands behind a row vector. False when it is
// anything else.
bool parseTransform(std::string_view text, ThreeMfTransform& transform);

}  // namespace handwheel::threemf
