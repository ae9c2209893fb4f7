// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceFromDrawing.h"

#include "base/NumberText.h"
#include "document/workpiece/WorkpieceProperties.h"
#include "document/workpiece/target/TargetImport.h"
#include "document/workpiece/target/TargetPosition.h"
#include "machining/target/files/DxfReader.h"
#include "machining/target/files/SvgReader.h"

#include <QtGlobal>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kOnDiameter = 2.0, kInChuck = 30.0;  // mm

// Whole millimetres, as bars are ordered and cut.
double wholeAbove(double mm) {
  return std::ceil(mm - 1e-6);
}

Note noteOn(const StockCylinder& bar) {
  return {QT_TRANSLATE_NOOP(
              "Note",
              "The drawing is the target of a new bar of ⌀%1 × %2 mm, with %3 mm left for facing at "
              "the free end. Enter another size in the panel Stock; for an exercise use Import target… in its panel."),
          {roundedText(bar.diameter, 6), roundedText(bar.length, 6), roundedText(kUsualAllowance, 6)}};
}

}  // namespace

bool looksLikeDrawing(std::string_view head) {
  return looksLikeDxf(head) || looksLikeSvg(head);
}

Result<OpenedFile> openDrawing(const DocumentKind& kind, const std::filesystem::path& path, Progress progress) {
  Result<ImportedTarget> imported = importTarget(path, UnturnedFaces::Refuse, progress);
  if (!imported) return imported.error();
  WorkpieceSnapshot bar;
  const std::pair<WorkpieceField, double> sizes[] = {
      {WorkpieceField::Diameter, wholeAbove(2.0 * imported->profile.largestRadius() + kOnDiameter)},
      {WorkpieceField::Length, wholeAbove(imported->profile.length() + kUsualAllowance + kInChuck)}};
  for (const auto& [field, size] : sizes) {
    if (const Status checked = checkValue(field, size); !checked) return checked.error();
    bar = withValue(std::move(bar), field, size);
  }
  bar.target = placedTarget(*imported, bar.stock);
  OpenedFile opened;
  opened.kind = &kind;
  opened.file.lost = {LostAttribute::Curves};
  opened.file.notes = {noteOn(bar.stock)};
  opened.file.notes.insert(opened.file.notes.end(), imported->notes.begin(), imported->notes.end());
  opened.content = std::make_shared<const WorkpieceSnapshot>(std::move(bar));
  return opened;
}

}  // namespace handwheel
