// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/threemf/ThreeMfVocabulary.h"

#include "document/formats/MeshTextValues.h"

namespace handwheel::threemf {

double millimetresPerUnit(QStringView unit) {
  struct Unit {
    const char16_t* name;
    double millimetres;
  };
  constexpr Unit kUnits[] = {{u"micron", 1e-3}, {u"millimeter", 1.0}, {u"centimeter", 10.0},
                             {u"inch", 25.4},   {u"foot", 304.8},     {u"meter", 1000.0}};
  for (const Unit& known : kUnits)
    if (unit == known.name) return known.millimetres;
  return 0.0;
}

LostAttribute lostWith(QStringView nameSpace, QStringView name) {
  if (nameSpace == kTriangleSets) return LostAttribute::Groups;
  if (name == u"colorgroup") return LostAttribute::Colour;
  if (name.startsWith(u"texture2d")) return LostAttribute::TextureCoordinates;
  if (name == u"beamlattice") return LostAttribute::Lines;
  return nameSpace == kMaterials || name == u"basematerials" ? LostAttribute::Materials : LostAttribute::Other;
}

bool parseTransform(std::string_view text, ThreeMfTransform& transform) {
  TextScanner scanner(text);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 3; ++column) {
      ErrorCode why;
      if (!parseNumber(scanner.wordOnAnyLine(), transform(column, row), why)) return false;
    }
  }
  return scanner.wordOnAnyLine().empty();
}

}  // namespace handwheel::threemf
