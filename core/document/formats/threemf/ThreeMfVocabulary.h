// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"
#include "document/formats/threemf/ThreeMfModel.h"

#include <QString>

// Namespaces, units and transforms in the model parts of 3MF files.
namespace handwheel::threemf {

inline const QString kCore = QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/core/2015/02");
inline const QString kProduction = QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/production/2015/06");
inline const QString kMaterials = QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/material/2015/02");
inline const QString kTriangleSets =
    QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07");

// Returns the length of a 3MF unit in mm; 0 for an unknown unit.
double millimetresPerUnit(QStringView unit);

// Returns the kind of content that is lost with an element that is not read.
LostAttribute lostWith(QStringView nameSpace, QStringView name);

// Parses a transform, "m00 m01 m02 m10 … m32". It is a matrix of four rows and three columns that is multiplied by a
// row vector from the left. Returns false for anything else.
bool parseTransform(std::string_view text, ThreeMfTransform& transform);

}  // namespace handwheel::threemf
