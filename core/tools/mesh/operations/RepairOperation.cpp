// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/RepairOperation.h"

#include "base/Tolerance.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/SharedParameters.h"

#include <QtGlobal>

namespace handwheel {
namespace {

static_assert(tolerance::kDebrisArea == 0.01 && tolerance::kDebrisFaces == 0.01, "as --remove-debris says");

Parameter goalParameter() {
  return {.property = {.id = "goal", .group = {}, .label = {}, .value = static_cast<double>(RepairOptions().goal)},
          .meaning =
              "What the part shall become: a closed solid, a surface whose outer boundaries stay open, or as it "
              "is but for what is certain",
          .word = "GOAL",
          .words = {"certain", "surface", "solid"}};  // in the order of RepairGoal
}

Parameter openSheetsParameter() {
  return {
      .property = {.id = "open-sheets", .group = {}, .label = {}, .value = static_cast<double>(RepairOptions().sheets)},
      .meaning = "Keep outer boundaries of open sheets open, thicken each sheet to a thin body, or fill them as holes",
      .word = "HOW",
      .words = {"keep", "back", "fill"},  // in the order of SheetHandling
      .formerId = "rims"};
}

}  // namespace

const Operation& repairOperation() {
  static const Operation operation = [] {
    Operation repair = {
        .id = "repair",
        .title = QT_TRANSLATE_NOOP("Tool", "Repair all"),
        .meaning = "As 'handwheel repair', but in the number type of the document, and keeping marked loops open",
        .parameters = fillParameters()};
    auto& all = repair.parameters;
    all.push_back(goalParameter());
    all.push_back(nearWeldParameter(RepairOptions().nearWeld));
    all.push_back(openSheetsParameter());
    all.push_back(thicknessParameter());
    all.push_back(countParameter("max-hole", "N", "Leave loops with more edges open; 0: no limit"));
    all.push_back(flagParameter("remove-debris",
                                "Remove parts with less than 1 % of the area and of the triangles of the largest"));
    all.push_back(flagParameter("keep-folded-regions",
                                "Leave holes open that close only if folded triangles around them are replaced"));
    all.back().formerId = "keep-tangles";
    all.push_back(flagParameter("cut-crossings", "Resolve self-intersections by cutting triangles apart"));
    all.push_back(flagParameter("unite",
                                "Unite bodies that intersect: what lies inside of the union is removed. Other "
                                "self-intersections are resolved as with 'cut-crossings'"));
    return repair;
  }();
  return operation;
}

RepairOptions repairOptionsOf(const OperationValues& values) {
  RepairOptions options;
  options.fill = fillOptionsOf(values);
  options.goal = static_cast<RepairGoal>(values.whole("goal"));
  options.nearWeld = values.number("near-weld");
  options.sheets = static_cast<SheetHandling>(values.whole("open-sheets"));
  options.thickness = values.given("thickness").value_or(0.0);
  options.maxEdges = values.whole("max-hole");
  options.removeDebris = values.flag("remove-debris");
  options.replaceFoldedRegions = !values.flag("keep-folded-regions");
  options.uniteSolids = values.flag("unite");
  options.cutCrossings = values.flag("cut-crossings");
  return options;
}

OperationValues valuesOf(const RepairOptions& options) {
  OperationValues values(repairOperation());
  setFillOptions(values, options.fill);
  values.setValid("goal", static_cast<double>(options.goal));
  values.setValid("near-weld", options.nearWeld);
  values.setValid("open-sheets", static_cast<double>(options.sheets));
  if (options.thickness > 0.0) values.setValid("thickness", options.thickness);
  values.setValid("max-hole", static_cast<double>(options.maxEdges));
  values.setValid("remove-debris", options.removeDebris);
  values.setValid("keep-folded-regions", !options.replaceFoldedRegions);
  values.setValid("cut-crossings", options.cutCrossings);
  values.setValid("unite", options.uniteSolids);
  return values;
}

}  // namespace handwheel
